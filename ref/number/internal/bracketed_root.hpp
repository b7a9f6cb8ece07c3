#pragma once
#include <optional>

#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// A root of f between `positive`, where f > 0, and `negative`, where f < 0, by the Illinois method (a modified false
/// position). It ends when a step is shorter than `tolerance`. Nothing if no step is, because f is NaN somewhere.
template <class Scalar, class Function>
std::optional<Scalar> bracketed_root(const Function& f, Scalar positive, Scalar negative,
                                     const Scalar& tolerance) {
  constexpr int most_steps = 200;
  Scalar above = f(positive);
  Scalar below = f(negative);
  Scalar last = positive;
  int side = 0;
  for (int step = 0; step < most_steps; ++step) {
    const Scalar x = (positive * below - negative * above) / (below - above);
    const Scalar change = x - last;
    if (change < tolerance && -change < tolerance) return x;
    last = x;
    const Scalar value = f(x);
    if (value > 0) {
      positive = x;
      above = value;
      if (side > 0) below /= 2;
      side = 1;
    } else {
      negative = x;
      below = value;
      if (side < 0) above /= 2;
      side = -1;
    }
  }
  return std::nullopt;
}

/// A proven bracket of a zero near `root`: the narrowest interval [root - d, root + d], d = distance, factor distance,
/// factor^2 distance, ... < most, with the sign `at_left` at its left end and -at_left at its right end. sign(x) is the
/// sign at x if it is proven, and 0 otherwise. Nothing if there is no such interval.
template <class Sign>
std::optional<Interval> proven_bracket(const Float& root, Float distance, const Float& most, int factor,
                                       int at_left, const Sign& sign) {
  for (; distance < most; distance *= factor) {
    const Float left = root - distance, right = root + distance;
    if (sign(left) == at_left && sign(right) == -at_left) return Interval(left, right, bits_of(left));
  }
  return std::nullopt;
}

}  // namespace nipref::ref
