#pragma once
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// The wall-clock seconds of one call of `work`.
double seconds_of(const std::function<void()>& work);

/// Returns the result of `work` and the seconds of the call.
auto timed(const auto& work) {
  std::optional<decltype(work())> found;
  const double seconds = seconds_of([&] { found.emplace(work()); });
  return std::pair(*std::move(found), seconds);
}

/// A computation to be timed: run(n) does the first n of `most` different evaluations.
struct Contender {
  std::function<void(std::size_t count)> run;
  std::size_t least;  ///< the least number of evaluations in a round that represents the range
  std::size_t most;
  /// The seconds for `passes` times the first `count` evaluations, measured by another process; empty: measured here.
  std::function<double(std::size_t count, std::size_t passes)> seconds = {};
};

struct Timing {
  double seconds;                 ///< median over the rounds of the time of one evaluation
  double quartile_1, quartile_3;  ///< quartiles of the rounds' times
  std::size_t count;              ///< number of different evaluations in a round
  std::vector<double> rounds;     ///< the time of one evaluation in each round
};

/// The quantile of the numbers at this share, which is 0.5 for the median. There must be at least one number.
double quantile(std::vector<double> numbers, double share);

/// Times the contenders in turn: each round runs all of them, so that a change of the machine's speed affects all
/// alike. A first measurement finds the number of evaluations that take about `seconds_per_round`.
std::vector<Timing> time_interleaved(const std::vector<Contender>& contenders, int rounds = 15,
                                     double seconds_per_round = 5e-3);

}  // namespace nipref::verify
