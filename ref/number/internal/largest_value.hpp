#pragma once
#include <functional>
#include <optional>

#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// Enclosures of a function's values, slopes and curvatures on an interval.
struct FunctionOver {
  Interval value, slope, curvature;
};

/// Enclosures of the largest value of a function and of all places where the function takes it.
struct LargestValue {
  Interval value, place;
};

/// The largest value on `range` of any function that differs from `near` by at most `value_error`, and whose slope
/// differs by at most `slope_error`: by bisection, and Newton's method where `near` is concave. Nothing if the largest
/// value may be at an end of `range`, or is not found.
std::optional<LargestValue> largest_value(const std::function<FunctionOver(const Interval&)>& near,
                                          const Interval& range, const Interval& value_error,
                                          const Interval& slope_error);

}  // namespace nipref::ref
