#include <nipref/verify/bench/internal/elastic_nip.hpp>
#include <nipref/verify/bench/internal/half_space.hpp>
#include <nipref/verify/bench/internal/viscoelastic_nip.hpp>
#include <nipref/verify/bench/render.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/options.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {
namespace {

constexpr auto notes =
    "\nMedians of interleaved rounds, one thread. time ratio: over fast at full accuracy, or over ref.\n"
    "max ulp, max rel: largest error against ref, in units in the last place of the scale (at N digits:\n"
    "10^-N of the scale) and relative to the value.\n"
    "GSL has no multiprecision quadrature, so that nothing of it stands beside ref.\n\n";

}  // namespace

int bench_verb(const CommandLine& line, std::ostream& out) {
  const Selection selected = selection(line, {"elastic-nip", "viscoelastic-nip", "half-space"});
  Progress progress;
  const BenchProgress show = [&](const std::string& what) { progress.show("bench " + what); };
  BenchReport report = bench(selected.quantities, show);
  if (selected.has("elastic-nip")) append(report, bench_contacts(show));
  if (selected.has("viscoelastic-nip")) append(report, bench_viscoelastic(show));
  if (selected.has("half-space")) append(report, bench_half_space(show));
  if (line.json) {
    out << answer_text("bench", bench_json(report), line.no_times);
  } else {
    out << bench_text(report.rows) << notes << ratios_text(report.ratios);
  }
  return 0;
}

}  // namespace nipref::verify
