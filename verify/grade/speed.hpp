#pragma once
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/catalogue/ranges.hpp>
#include <nipref/verify/grade/plugin.hpp>

namespace nipref::verify {

struct Contender;

/// A way to compute values at points: it fills `values` for the first of them.
struct BatchMethod {
  std::function<void(std::span<double> values)> evaluate;
  std::function<double(std::size_t count, std::size_t passes)> seconds = {};  ///< see Contender

  [[nodiscard]] Contender contender(std::size_t least, std::size_t most) const;
};

/// A loop or a batch of a quantity of the catalogue, to which it refers.
BatchMethod method_of(const decltype(Quantity::by_fast_loop)& evaluate, fast::Accuracy accuracy,
                      const std::vector<Point>& points);
/// A kernel, which counts as infinitely slow from its first failure on. It refers to the kernel and the points.
BatchMethod method_of(PluginKernel& kernel, const std::vector<Point>& points);

/// The times of two implementations, measured alternately, so that changes of the machine's speed affect both. Stored
/// times would be useless, as they differ by a quarter between runs.
struct Speed {
  double nanoseconds;        ///< for one value, median of the rounds
  double other_nanoseconds;  ///< the same for the other implementation
  double lower_ratio, ratio,
      upper_ratio;  ///< over the rounds, of its time over the other's; `ratio` is the median

  /// `lower`: the share of the rounds whose ratio is below lower_ratio, as large as that above upper_ratio.
  Speed(const std::vector<double>& nanoseconds_of_rounds, const std::vector<double>& others, double lower);

  /// Slower by more than `part` in every round, if `lower` is 0: what one round in three says alone is the machine's.
  [[nodiscard]] bool slower_by(double part) const { return lower_ratio > 1 + part; }
};

/// Random points of the ranges at which fast has finite values; empty if there are none.
std::vector<Point> timing_points(const Quantity& quantity, const Ranges& ranges);

/// Times two methods of so many values side by side, both at as many of them as the slower one bears. There must be at least
/// one. Nothing if one of them fails.
std::optional<Speed> in_turns(const BatchMethod& one, const BatchMethod& other, std::size_t points);

}  // namespace nipref::verify
