#pragma once
#include <cmath>

#include <nipref/fast/number/two_words.hpp>

namespace nipref::fast::internal {

// What algebra with square roots needs beyond two_words.hpp; each good to a few units of 2^-104 of its
// largest operand. Finite arguments.

inline Two operator-(Two a, Two b) { return a + -b; }

inline Two operator*(double a, Two b) {
  const Two product = two_product(a, b.high);
  return two_sum_ordered(product.high, std::fma(a, b.low, product.low));
}

/// The reciprocal first: it need not wait for a.
inline Two operator/(Two a, Two b) {
  const double reciprocal = 1 / b.high;
  const double quotient = a.high * reciprocal;
  const Two rest = a - quotient * b;
  return two_sum_ordered(quotient, rest.high * reciprocal);
}

/// a > 0: one step of Newton from the root of the high word.
inline Two sqrt(Two a) {
  const double root = std::sqrt(a.high);
  const double slope = 0.5 / root;
  const Two rest = a - two_product(root, root);
  return two_sum_ordered(root, rest.high * slope);
}

inline Two twice(Two a) { return {2 * a.high, 2 * a.low}; }

inline Two square(Two a) { return a * a; }

inline double rounded(Two a) { return a.high + a.low; }

}  // namespace nipref::fast::internal
