#pragma once
#include <cmath>

#include <nipref/fast/number/two_words.hpp>

namespace nipref::fast::internal {

// Quotients, square roots and logarithms in two words, in addition to two_words.hpp. Arguments are finite; the error
// is a few times 2^-104 of the largest operand.

inline Two operator-(Two a, Two b) { return a + -b; }

inline Two operator*(double a, Two b) {
  const Two product = two_product(a, b.high);
  return two_sum_ordered(product.high, std::fma(a, b.low, product.low));
}

/// Multiplies by the reciprocal of b, which the processor can compute before a is known.
inline Two operator/(Two a, Two b) {
  const double reciprocal = 1 / b.high;
  const double quotient = a.high * reciprocal;
  const Two rest = a - quotient * b;
  return two_sum_ordered(quotient, rest.high * reciprocal);
}

/// The square root of a > 0, by one Newton step from the root of the high word.
inline Two sqrt(Two a) {
  const double root = std::sqrt(a.high);
  const double slope = 0.5 / root;
  const Two rest = a - two_product(root, root);
  return two_sum_ordered(root, rest.high * slope);
}

inline Two twice(Two a) { return {2 * a.high, 2 * a.low}; }

inline Two square(Two a) { return a * a; }

inline double rounded(Two a) { return a.high + a.low; }

/// The logarithm of a > 0 whose square neither overflows nor underflows: the logarithm of the nearest power of 2 plus
/// the logarithm of a divided by this power, for which the series of the inverse hyperbolic tangent is used.
inline Two log(Two a) {
  constexpr Two ln2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
  constexpr int last = 43;  // z^2 < 0.0295
  int exponent = 0;
  if (std::frexp(a.high, &exponent) < 0x1.6a09e667f3bcdp-1) --exponent;
  const double scale = std::scalbn(1.0, -exponent);
  const Two rest{a.high * scale, a.low * scale};
  const Two z = (rest - Two{1}) / (rest + Two{1}), squared = square(z);
  Two sum{0};
  for (int k = last; k > 0; k -= 2) sum = Two{1} / k + squared * sum;
  return exponent * ln2 + twice(z) * sum;
}

}  // namespace nipref::fast::internal
