#pragma once
#include <cmath>
#include <concepts>

#include <nipref/fast/number/two_words.hpp>

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

/// The same to two words, from the last double: `holds` is a predicate of two words.
Two last_in_two_words(std::predicate<Two> auto holds, double last) {
  const auto holds_beyond = [&](double low) { return holds(two_sum(last, low)); };
  return {last, last_that(holds_beyond, 0, std::nextafter(last, HUGE_VAL) - last)};
}

}  // namespace nipref::fast::internal
