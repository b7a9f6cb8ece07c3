#include <algorithm>

#include <nipref/verify/bench/internal/elastic_nip.hpp>
#include <nipref/verify/bench/internal/half_space.hpp>
#include <nipref/verify/bench/internal/viscoelastic_nip.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/bench_all.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>

namespace nipref::verify {

std::vector<std::string_view> bench_groups() { return {"elastic-nip", "viscoelastic-nip", "half-space"}; }

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
    append(report, bench({quantity}, show, others));
  }
  const auto add = [&](const char* group, BenchReport (*bench_group)(const BenchProgress&)) {
    if (!selected.has(group) || interrupted()) return;
    progress.next(group);
    append(report, bench_group(show));
  };
  add("elastic-nip", bench_contacts);
  add("viscoelastic-nip", bench_viscoelastic);
  add("half-space", bench_half_space);
  mark_pareto_optimal(report.rows);
  return report;
}

}  // namespace nipref::verify
