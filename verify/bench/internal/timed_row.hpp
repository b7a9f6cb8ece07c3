#pragma once
#include <string>

#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {

/// The row of a timing, without errors; an evaluation is of `values` values. Its ratio is that to `over`.
inline BenchRow timed_row(std::string quantity, std::string arguments, std::string method,
                          const Timing& timing, const Timing& over, double values = 1) {
  const double nanoseconds = 1e9 / values;
  return {std::move(quantity),
          std::move(arguments),
          std::move(method),
          nanoseconds * timing.seconds,
          {},
          {},
          timing.seconds / over.seconds,
          nanoseconds * timing.quartile_1,
          nanoseconds * timing.quartile_3};
}

}  // namespace nipref::verify
