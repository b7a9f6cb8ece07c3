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

/// A method that computes values at points: it fills `values` with those of the first points.
struct BatchMethod {
  std::function<void(std::span<double> values)> evaluate;
  std::function<double(std::size_t count, std::size_t passes)> seconds = {};  ///< see Contender

  [[nodiscard]] Contender contender(std::size_t least, std::size_t most) const;
};

/// The method of a loop or batch function of a quantity in the catalogue. It refers to this function.
BatchMethod method_of(const decltype(Quantity::by_fast_loop)& evaluate, fast::Accuracy accuracy,
                      const std::vector<Point>& points);
/// The method of a kernel, which is infinitely slow from its first failure on. It refers to the kernel and the points.
BatchMethod method_of(PluginKernel& kernel, const std::vector<Point>& points);

/// The times of two implementations, measured alternately, so that changes of the machine's speed affect both. Stored
/// times would be useless, as they differ by a quarter between runs.
struct Speed {
  double nanoseconds;        ///< for one value, median of the rounds
  double other_nanoseconds;  ///< the same for the other implementation
  /// Quantiles over the rounds of the ratio of its time to the other's; `ratio` is the median.
  double lower_ratio, ratio, upper_ratio;

  /// `lower` is the share of rounds with a ratio below lower_ratio. The share above upper_ratio is as large.
  Speed(const std::vector<double>& nanoseconds_of_rounds, const std::vector<double>& others, double lower);

  /// Whether it is slower by more than `part`: in every round if `lower` is 0, as a single round may be disturbed.
  [[nodiscard]] bool slower_by(double part) const { return lower_ratio > 1 + part; }
};

/// Random points of the ranges at which fast has finite values; empty if there are none.
std::vector<Point> timing_points(const Quantity& quantity, const Ranges& ranges);

/// Times two methods of `points` values alternately, both at the number of values that the slower one computes in a
/// round. There must be at least one point. Nothing if one of the methods fails.
std::optional<Speed> in_turns(const BatchMethod& one, const BatchMethod& other, std::size_t points);

}  // namespace nipref::verify
