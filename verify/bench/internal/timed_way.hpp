#pragma once
#include <functional>
#include <string>
#include <vector>

#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {

/// The largest error of a way to compute some values.
struct WayError {
  std::optional<double> ulps, relative;
};
inline WayError of_relative(double error) { return {error / 0x1p-52, error}; }

/// One of several ways to compute the same values.
struct TimedWay {
  std::string name;
  Contender contender;
  std::function<WayError()> error = {};  ///< found after the times; empty: nothing independent is compared
};

struct TimedRounds {
  std::size_t over = 0;  ///< the way whose time the ratios are to
  int count = 15;
  double seconds = 5e-3;            ///< of a round
  double values_in_evaluation = 1;  ///< which are timed as one
};

/// Times the ways side by side: a row for each.
std::vector<BenchRow> timed_rows(const std::string& quantity, const std::string& arguments,
                                 const std::vector<TimedWay>& ways, const TimedRounds& rounds);

/// A contender that calls work(i) for i from 0 to count - 1.
template <class Work>
Contender repeated(Work work, std::size_t most = 1000) {
  return {[work](std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) static_cast<void>(work(i));
          },
          1, most};
}

}  // namespace nipref::verify
