#pragma once
#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// The place of the only maximum of f between `low` and `high`, by golden-section search to within `tolerance`. The
/// error of the maximum itself is of the order of the square of that.
template <class Function>
Float place_of_largest(const Function& f, Float low, Float high, const Float& tolerance) {
  const Float golden = (sqrt(Float(5)) - 1) / 2;
  Float left = high - golden * (high - low), right = low + golden * (high - low);
  Float at_left = f(left), at_right = f(right);
  while (high - low > tolerance) {
    if (at_left > at_right) {
      high = right;
      right = left, at_right = at_left;
      left = high - golden * (high - low), at_left = f(left);
    } else {
      low = left;
      left = right, at_left = at_right;
      right = low + golden * (high - low), at_right = f(right);
    }
  }
  return at_left > at_right ? left : right;
}

}  // namespace nipref::ref
