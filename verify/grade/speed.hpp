#pragma once
#include <optional>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/catalogue/ranges.hpp>
#include <nipref/verify/grade/plugin.hpp>

namespace nipref::verify {

/// The times of two implementations, measured alternately, so that changes of the machine's speed affect both. Stored
/// times would be useless, as they differ by a quarter between runs.
struct Speed {
  double nanoseconds;                      ///< for one value, median of the rounds
  double other_nanoseconds;                ///< the same for the other implementation
  double lower_ratio, ratio, upper_ratio;  ///< quartiles, over the rounds, of its time over the other's
};

/// Random points of the ranges at which fast has finite values; empty if there are none.
std::vector<Point> timing_points(const Quantity& quantity, const Ranges& ranges);

/// Compares the kernel with fast at full accuracy, both in batches if they can, each in its own process. There must
/// be at least one point. Nothing if the kernel fails.
std::optional<Speed> speed_against_fast(PluginKernel& kernel, const Quantity& quantity,
                                        const std::vector<Point>& points);

/// Compares the kernel with an older kernel of the same arguments. There must be at least one point. Nothing if one of
/// them fails.
std::optional<Speed> speed_against(PluginKernel& kernel, PluginKernel& older,
                                   const std::vector<Point>& points);

}  // namespace nipref::verify
