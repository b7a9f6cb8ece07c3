#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// The errors at the points whose magnitude of one argument lies in [10^exponent, 10^(exponent + 1)).
struct Decade {
  std::optional<int> exponent;  ///< none: the argument is 0
  std::size_t points;
  std::size_t above;  ///< that break the promise
  double max_ulp;
  double median_ulp;
};

/// The smallest box of arguments that holds every point at which the promise is broken.
struct WrongRegion {
  Point lower, upper;
  std::size_t points;  ///< looked at in it
  std::size_t above;   ///< of them break the promise
};

/// One of the points that stand for all in a plot.
struct ErrorDot {
  double at;     ///< the argument
  double ulps;   ///< units in the last place of the scale
  bool largest;  ///< of its part of the axis
};

/// Whether values of such an argument, which spans decades, are told by their magnitude.
bool spans_decades(ArgumentKind kind);

// Ends of the axis of such values: most doubles are much smaller or larger, and tell nothing new.
inline constexpr double least_of_axis = 1e-12, most_of_axis = 1e12;

/// Where a value of such an argument lies on the axis, or of another kind itself.
double place_on_axis(ArgumentKind kind, double value);

/// How errors are spread over points. A largest error alone misleads where it is a spike.
struct ErrorSpread {
  double mean, median, percentile_90, percentile_99,
      percentile_999;  ///< units in the last place of the scale
  // Of points that are kept, by add_places:
  std::size_t along = 0;             ///< the number of the argument by whose decades the errors are sorted
  std::vector<Decade> decades = {};  ///< in the order of magnitude
  std::optional<WrongRegion> wrong = {};
  /// In the order of the argument, or of its magnitude where that spans decades: of each of a hundred parts of its axis
  /// the largest and a few more. What lies beyond the ends of such an axis, 0 too, is taken to lie there. Errors that are
  /// infinite are left out.
  std::vector<ErrorDot> dots = {};
};

/// The error at one point.
struct Finding {
  double ulps;            ///< units in the last place of the scale
  double relative;        ///< of the value
  double allowance_used;  ///< error over what is allowed
};

class ErrorTally;

/// Percentiles are errors that at least so many of a hundred points do not exceed: a thirty-second more at most than the
/// smallest such error that was found, or 1/64 where that is less, and never more than the largest. Of at least one.
ErrorSpread error_spread(const ErrorTally& errors);
/// Where they lie. Of at least one point; each has a finding.
void add_places(ErrorSpread& spread, const Quantity& quantity, std::span<const Point> points,
                std::span<const Finding> findings);
/// Both.
ErrorSpread error_spread(const Quantity& quantity, std::span<const Point> points,
                         std::span<const Finding> findings);

}  // namespace nipref::verify
