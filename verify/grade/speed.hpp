#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/catalogue/ranges.hpp>
#include <nipref/verify/grade/plugin.hpp>

namespace nipref::verify {

/// Two ways to the same values, timed in turns, so that a change of the machine's speed meets both alike. Stored times
/// would say nothing: they differ by a quarter between runs.
struct Speed {
  double nanoseconds;                      ///< a value, median over the rounds
  double other_nanoseconds;                ///< of the other way
  double lower_ratio, ratio, upper_ratio;  ///< quartiles over the rounds of its time over the other's
};

/// Random points of the ranges for timing, at which fast has values; none if it has none.
std::vector<Point> timing_points(const Quantity& quantity, const Ranges& ranges);

/// The kernel beside fast at full accuracy, in batches where fast and the kernel have them, each in its own process.
/// Nothing if the kernel fails. At least one point.
std::optional<Speed> speed_against_fast(PluginKernel& kernel, const Quantity& quantity,
                                        const std::vector<Point>& points);

/// The kernel beside an older one of the same arguments. Nothing if one of them fails. At least one point.
std::optional<Speed> speed_against(PluginKernel& kernel, PluginKernel& older,
                                   const std::vector<Point>& points);

/// "52 ns a value, 1.03 times the 50 ns of fast (quartiles 1.01 to 1.06)".
std::string speed_text(const Speed& speed, const std::string& other);

}  // namespace nipref::verify
