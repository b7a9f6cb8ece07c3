#pragma once
#include <cmath>
#include <concepts>

#include <nipref/fast/number/two_words.hpp>

namespace nipref::fast::internal {

/// Finds by bisection the last double of [low, high) for which `holds` is true. `holds` must be true at low, and false
/// from some double on. Bisection, unlike faster methods, allows a function that ends at a branch point before its root.
double last_that(std::predicate<double> auto holds, double low, double high) {
  while (true) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) return low;
    (holds(middle) ? low : high) = middle;
  }
}

/// Refines `last`, the last double for which `holds` is true, to the last number of two words.
Two last_in_two_words(std::predicate<Two> auto holds, double last) {
  const auto holds_beyond = [&](double low) { return holds(two_sum(last, low)); };
  return {last, last_that(holds_beyond, 0, std::nextafter(last, HUGE_VAL) - last)};
}

}  // namespace nipref::fast::internal
