#pragma once
#include <concepts>

namespace nipref::fast::internal {

/// The last double of [low, high) for which `holds` is true, by bisection. `holds` must be true at low, and false from
/// some double on. No faster method is used since a function may end at a branch point before its root.
double last_that(std::predicate<double> auto holds, double low, double high) {
  while (true) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) return low;
    (holds(middle) ? low : high) = middle;
  }
}

}  // namespace nipref::fast::internal
