#pragma once
#include <functional>
#include <optional>

#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// What contains a function's values, slopes and curvatures on an interval.
struct FunctionOver {
  Interval value, slope, curvature;
};

/// What contains the largest value of a function, and all places where it is.
struct LargestValue {
  Interval value, place;
};

/// That on `range` of any function that differs from `near` by at most `value_error`, and in its slope by at most
/// `slope_error`; nothing if it may be at an end, or is not found. By bisection, and Newton's method where `near` is concave.
std::optional<LargestValue> largest_value(const std::function<FunctionOver(const Interval&)>& near,
                                          const Interval& range, const Interval& value_error,
                                          const Interval& slope_error);

}  // namespace nipref::ref
