#pragma once
#include <concepts>

namespace nipref::fast::internal {

/// The last double of [low, high) for which `holds` is true, if it holds at low and nowhere beyond the first
/// double where it fails. Bisection: the functions behind `holds` may end at a branch point before their
/// root.
double last_that(std::predicate<double> auto holds, double low, double high) {
  while (true) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) return low;
    (holds(middle) ? low : high) = middle;
  }
}

}  // namespace nipref::fast::internal
