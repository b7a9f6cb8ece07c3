#pragma once
#include <cstddef>
#include <functional>
#include <vector>

namespace nipref::verify {

/// Wall-clock seconds that one call of `work` takes.
double seconds_of(const std::function<void()>& work);

/// Something to time: run(n) does the first n of `most` different evaluations.
struct Contender {
  std::function<void(std::size_t count)> run;
  std::size_t least;  ///< a round has at least so many, however slow: fewer would not stand for the range
  std::size_t most;
  /// Seconds of so many times the first n, measured where they are done; empty: they are measured here.
  std::function<double(std::size_t count, std::size_t passes)> seconds = {};
};

struct Timing {
  double seconds;                 ///< median over the rounds of the time of one evaluation
  double quartile_1, quartile_3;  ///< of the same
  std::size_t count;              ///< different evaluations in a round
};

/// Times the contenders side by side: each round runs every one of them once, so that a change of the
/// machine's speed meets all alike; the number of evaluations in a round follows from a first measurement,
/// about `seconds_per_round`.
std::vector<Timing> time_interleaved(const std::vector<Contender>& contenders, int rounds = 15,
                                     double seconds_per_round = 5e-3);

}  // namespace nipref::verify
