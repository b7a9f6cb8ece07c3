#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/support/internal/progress.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// What is timed besides quantities.
std::vector<std::string_view> bench_groups();

/// All that is timed without being named: the groups, and the quantities that are not costly.
Selection bench_everything();

/// Times what is selected, of quantities and bench_groups(). What is finished, if the process is interrupted.
BenchReport bench_all(const Selection& selected, Progress& progress,
                      const std::vector<OtherKernel>& others = {});

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
