#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>

#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/bench/internal/groups.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/bench.hpp>
#include <nipref/verify/cli/machine.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {

namespace {

constexpr auto notes =
    "\nMedians and quartiles of interleaved rounds, one thread. ratio: of times, over fast at full accuracy, or over ref.\n"
    "*: none of the ways to the same values was as quick and more right, or as right and quicker.\n"
    "max ulp, max rel: largest error against ref, in units in the last place of the scale (at N digits 10^-N of the scale) and "
    "relative to the value.\n"
    "GSL has no multiprecision quadrature, so that nothing of it stands beside ref.\n";

/// What this run was asked for, to ask the same of an older program.
std::vector<std::string> words_of(const CommandLine& line) {
  std::vector<std::string> words = line.words;
  if (const auto isa = line.option("isa")) words.insert(words.end(), {"--isa", *isa});
  return words;
}

/// The kernels of a shared object, if one is named.
class OtherKernels {
 public:
  explicit OtherKernels(const std::optional<std::string>& file) {
    if (!file) return;
    for (const KernelInfo& info : kernels_of({*file})) {
      kernels_.push_back(std::make_unique<PluginKernel>(Plugin{*file}, info.name));
      all_.push_back({info.name + " of " + std::filesystem::path(*file).filename().string(), info.quantity,
                      kernels_.back().get()});
    }
  }
  [[nodiscard]] const std::vector<OtherKernel>& all() const { return all_; }

 private:
  std::vector<std::unique_ptr<PluginKernel>> kernels_;
  std::vector<OtherKernel> all_;
};

int against_verb(const CommandLine& line, std::ostream& out) {
  const auto most = max_slowdown_option(line);
  Progress progress(standard_error(line.has("quiet")));
  const std::vector<AgainstRow> rows = bench_against(*line.option("against"), words_of(line), progress);
  if (line.json) {
    out << answer_text("bench_against", {{"rows", against_json(rows)}}, line.no_times);
  } else {
    out << against_text(rows);
  }
  const auto too_slow = [&](const AgainstRow& row) { return row.slower_by(*most); };
  return most && std::ranges::any_of(rows, too_slow) ? 1 : 0;
}

}  // namespace

int bench_verb(const CommandLine& line, std::ostream& out) {
  const Selection selected = line.words.empty() ? bench_everything() : selection(line, bench_groups());
  static_cast<void>(max_slowdown_option(line));
  if (line.option("against")) return against_verb(line, out);
  const OtherKernels others(line.option("with"));
  stop_gently_on_interrupt();
  Progress progress(standard_error(line.has("quiet")));
  const BenchReport report = bench_all(selected, progress, others.all());
  if (line.json) {
    out << answer_text("bench", bench_json(report), line.no_times);
  } else {
    out << folded(ratios_text(report.ratios) + bench_text(report.rows) + notes + machine_text() + "\n" +
                  interruption_text());
  }
  return all_met(report, line.has("strict")) ? 0 : 1;
}

std::vector<std::string_view> bench_groups() {
  std::vector<std::string_view> names;
  std::ranges::transform(bench_group_table, std::back_inserter(names), &BenchGroup::name);
  return names;
}

Selection bench_everything() {
  Selection all{select_quantities({}), bench_groups()};
  std::erase_if(all.quantities, &Quantity::is_costly);
  return all;
}

BenchReport bench_all(const Selection& selected, Progress& progress, const std::vector<OtherKernel>& others) {
  progress.begin("bench", selected.quantities.size() + selected.groups.size());
  const BenchProgress show = [&](const std::string& what) { progress.at(0, what); };
  BenchReport report;
  for (const Quantity* quantity : selected.quantities) {
    if (interrupted()) break;
    progress.next(quantity->name);
    std::ranges::move(bench(*quantity, show, others), std::back_inserter(report.rows));
  }
  for (const BenchGroup& group : bench_group_table) {
    if (!selected.has(group.name) || interrupted()) continue;
    progress.next(std::string(group.name));
    std::ranges::move(bench_group(group, show), std::back_inserter(report.rows));
  }
  report.ratios = promised_ratios(report.rows);
  mark_pareto_optimal(report.rows);
  return report;
}

}  // namespace nipref::verify
