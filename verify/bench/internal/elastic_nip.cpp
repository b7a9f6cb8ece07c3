#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/data/table/index.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/verify/bench/internal/elastic_nip.hpp>
#include <nipref/verify/bench/internal/timed_row.hpp>
#include <nipref/verify/catalogue/ulp.hpp>
#include <nipref/verify/replay/internal/elastic_nip.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

using data::ElasticNip;
using data::Friction;

constexpr int length_digits = 20;
constexpr auto elastic_nip = "elastic-nip";
constexpr auto method_of_the_thesis = "thesis: m=10, 500 terms";
constexpr auto arguments_to_compare = "B=0.005 W=100";

struct Case {
  std::string arguments;
  ElasticNip nip;
  double load;
};

/// The sheets of the thesis, at the middle of its loads.
std::vector<Case> cases() {
  std::vector<Case> all;
  for (const double thickness : data::seed::sheet_thicknesses) {
    all.push_back({fmt::format("B={} W=100", thickness), data::seed::nip(thickness), 100});
  }
  return all;
}

/// Finds the contact length.
struct ElasticNipMethod {
  std::string name;
  std::function<double()> length;
};

std::vector<ElasticNipMethod> methods(const Case& at) {
  std::vector<ElasticNipMethod> all;
  all.push_back({method_of_the_thesis, [&at] {
                   const fast::LoadSearch search{fast::LoadSearch::Iteration::thesis, 2e-3};
                   return fast::line_loads_for_load(at.nip, {10, 500}, at.load, search).contact_length;
                 }});
  all.push_back({"line loads, m=10, fast kernels",
                 [&at] { return fast::line_loads_for_load(at.nip, 10, at.load).contact_length; }});
  for (const double accuracy : {1e-4, 1e-7, 1e-10, 1e-13}) {
    all.push_back(
        {fmt::format("converged {:.0e}", accuracy), [&at, accuracy] {
           return fast::converged_for_load(at.nip, Friction::none, at.load, accuracy).contact_length().value;
         }});
  }
  all.push_back(
      {"converged 1e-10, full friction", [&at] {
         return fast::converged_for_load(at.nip, Friction::full, at.load, 1e-10).contact_length().value;
       }});
  return all;
}

Contender contender(const std::function<double()>& work) {
  return {[work](std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) static_cast<void>(work());
          },
          1, 1000};
}

std::vector<BenchRow> rows_of(const Case& at, int rounds) {
  const auto all = methods(at);
  std::vector<Contender> contenders;
  for (const ElasticNipMethod& method : all) contenders.push_back(contender(method.length));
  const auto timings = time_interleaved(contenders, rounds);
  const ref::Estimate truth = ref::converged_for_load(at.nip, at.load, length_digits).contact_length();
  std::vector<BenchRow> rows;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double length = all[i].length();
    const bool comparable = all[i].name.find("friction") == std::string::npos;
    rows.push_back(timed_row(elastic_nip, at.arguments, all[i].name, timings[i], timings[4]));
    if (!comparable) continue;
    const double error = std::fabs(truth.error_of(length));
    rows.back().max_error_ulp = error / ulp_of(length);
    rows.back().max_relative_error = error / length;
  }
  return rows;
}

/// Time and error of one row over those of another.
BenchRatio ratio(std::string what, double slow, double quick, double target) {
  return {std::move(what), slow / quick, target};
}

/// All rows of Tables III to X, from loaded tables.
BenchRow replay_row(int rounds) {
  std::vector<data::Table> tables;
  for (const LineLoadTable& table : line_load_tables()) {
    tables.push_back(data::load_table_by_id(std::string(table.id)));
  }
  const auto replay_all = [&] {
    double cells = 0;
    for (const LineLoadTable& table : line_load_tables()) {
      const auto index = static_cast<std::size_t>(&table - line_load_tables().data());
      cells += static_cast<double>(
          replay_line_loads(tables[index], table.friction, table.elements_per_side).cells.size());
    }
    return cells;
  };
  const auto timings = time_interleaved({contender(replay_all)}, rounds);
  BenchRow row = timed_row(elastic_nip, "all rows of Tables III-X", "replay", timings[0], timings[0]);
  row.ratio.reset();
  return row;
}

}  // namespace

BenchReport bench_contacts(const BenchProgress& progress, int rounds) {
  BenchReport report;
  for (const Case& at : cases()) {
    if (interrupted()) break;
    progress(at.arguments);
    const auto rows = rows_of(at, rounds);
    if (at.arguments == arguments_to_compare) {
      const BenchRow& thesis = rows[0];
      const BenchRow& converged = rows[4];
      report.ratios.push_back(ratio("time of the thesis's contact over converged 1e-10", thesis.nanoseconds,
                                    converged.nanoseconds, 1));
      BenchRatio errors =
          ratio("error of the same", *thesis.max_relative_error, *converged.max_relative_error, 1e5);
      errors.of_errors = true;
      report.ratios.push_back(errors);
      const BenchRow replay = replay_row(rounds);
      report.ratios.push_back(
          ratio("100 such solves over the replay of III-X", 100 * thesis.nanoseconds, replay.nanoseconds, 1));
      report.rows.push_back(replay);
    }
    report.rows.insert(report.rows.end(), rows.begin(), rows.end());
  }
  return report;
}

BenchReport bench_contacts(const BenchProgress& progress) { return bench_contacts(progress, 15); }

}  // namespace nipref::verify
