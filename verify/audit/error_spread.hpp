#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// The errors at the points at which the magnitude of one argument lies in [10^exponent, 10^(exponent + 1)).
struct Decade {
  std::optional<int> exponent;  ///< nothing if the argument is 0
  std::size_t points;
  std::size_t above;  ///< points that break the promise
  double max_ulp;
  double median_ulp;
};

/// The smallest box of arguments that contains every point at which the promise is broken.
struct WrongRegion {
  Point lower, upper;
  std::size_t points;  ///< points in it
  std::size_t above;   ///< points that break the promise
};

/// A point of a plot, which shows a selection of all points.
struct ErrorDot {
  double at;     ///< the argument
  double ulps;   ///< units in the last place of the scale
  bool largest;  ///< whether it is the largest error in its part of the axis
};

/// Whether arguments of this kind span decades, so that a plot shows their magnitude on a logarithmic axis.
bool spans_decades(ArgumentKind kind);

/// The position of a value on its axis. A logarithmic axis goes from 1e-12 to 1e12: most doubles are much smaller or
/// larger, but errors there are like those at the ends of the axis.
double place_on_axis(ArgumentKind kind, double value);

/// The distribution of errors over the arguments. The largest error alone would mislead where it is a spike.
struct ErrorSpread {
  std::size_t along = 0;             ///< index of the argument by whose decades the errors are grouped
  std::vector<Decade> decades = {};  ///< in ascending order
  std::optional<WrongRegion> wrong = {};
  /// For each of a hundred parts of the argument's axis the largest error and a few more, in the order of the axis.
  /// Values beyond the ends of a logarithmic axis, and 0, are put at its ends. Infinite errors are left out.
  std::vector<ErrorDot> dots = {};
};

/// The error at one point.
struct Finding {
  Point point;
  double ulps;            ///< units in the last place of the scale
  double relative;        ///< relative to the value
  double allowance_used;  ///< error over the allowed error
};

/// The distribution of the errors of these findings. There must be at least one finding.
ErrorSpread error_spread(const Quantity& quantity, std::span<const Finding> findings);

}  // namespace nipref::verify
