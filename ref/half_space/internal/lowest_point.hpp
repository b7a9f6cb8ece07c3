#pragma once

namespace nipref::ref {

/// The minimum of a function between `left` and `right`, by bisection with the sign of its slope.
template <class Scalar, class Slope>
Scalar lowest_point(const Slope& slope, Scalar left, Scalar right, int bisections) {
  for (int step = 0; step < bisections; ++step) {
    const Scalar middle = (left + right) / 2;
    (slope(middle) < 0 ? left : right) = middle;
  }
  return (left + right) / 2;
}

}  // namespace nipref::ref
