#include <algorithm>
#include <cmath>
#include <string_view>

#include <nipref/verify/audit/render.hpp>
#include <nipref/verify/report/report.hpp>

namespace nipref::verify {
namespace {

/// The columns in which an error of the seeds is searched.
struct SeedColumn {
  std::string_view what;
  std::string_view tables;  ///< the beginning of their ids
  std::string_view weakness;
  std::string_view column;  ///< the beginning of its name
};

constexpr SeedColumn seed_columns[] = {
    {"contact length L of the thesis", "thesis-", "discretisation", "L"},
    {"rolling resistance mu_R of the thesis", "thesis-", "discretisation", "muR"},
    {"span ratio of Brock's Table 1 (2013)", "brock2013-1", "formula", "c="}};

}  // namespace

bool Report::kept(bool strict) const {
  const auto none_broken = [](const auto& rows, auto is_kept) { return std::ranges::all_of(rows, is_kept); };
  return all_kept(quantities) && all_kept(hard_cases) && all_kept(scenes) && witness.agrees() &&
         !tables_fall_short && all_met(speed, strict) && none_broken(limits, &LimitRow::approached) &&
         none_broken(errata, [](const SettledErratum& one) { return one.settlement.settled(); }) &&
         none_broken(golden, [](const GoldenSample& one) { return one.checked.kept(); });
}

const AuditResult* closest_to_its_promise(const std::vector<AuditResult>& results) {
  const auto closest = std::ranges::max_element(results, {}, &AuditResult::allowance_used);
  return closest == results.end() ? nullptr : &*closest;
}

std::vector<SeedError> seed_errors(const std::vector<Replay>& tables) {
  std::vector<SeedError> errors;
  for (const SeedColumn& where : seed_columns) {
    SeedError largest{};
    for (const Replay& replay : tables) {
      if (!replay.table.id.starts_with(where.tables)) continue;
      for (const Cost& cost : replay.costs) {
        for (const ColumnDeviation& column : cost.columns) {
          if (cost.weakness == where.weakness && column.column.starts_with(where.column) &&
              (largest.what.empty() || std::fabs(column.largest) > std::fabs(largest.relative)))
            largest = {std::string(where.what), replay.table.id, column.largest,
                       cost.weakness + ", " + cost.against};
        }
      }
    }
    if (!largest.what.empty()) errors.push_back(largest);
  }
  return errors;
}

}  // namespace nipref::verify
