#pragma once
#include <optional>
#include <string>
#include <vector>

#include <nipref/verify/support/internal/progress.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// One way to a quantity's values in an older program and in this one.
struct AgainstRow {
  std::string quantity, range, method;
  double old_nanoseconds, new_nanoseconds;  ///< for one value, medians over the rounds
  double ratio;                             ///< new over old, median of the rounds' ratios
  double least_ratio, largest_ratio;        ///< of the rounds
  std::optional<double> old_ulp, new_ulp;   ///< largest errors found, units in the last place of the scale

  /// Slower by more than `part` in every round: what one round in three says alone is the machine's.
  [[nodiscard]] bool slower_by(double part) const { return least_ratio > 1 + part; }
};

/// Runs `bench` of both programs in turns, a few rounds, with the same words. Rows that both have. BadInput naming
/// "against" if the older one does not answer as nipref does.
std::vector<AgainstRow> bench_against(const std::string& old_program, const std::vector<std::string>& words,
                                      Progress& progress);

std::string against_text(const std::vector<AgainstRow>& rows);
Json against_json(const std::vector<AgainstRow>& rows);

}  // namespace nipref::verify
