#pragma once
#include <cmath>

#include <nipref/data/strict_arithmetic.hpp>

namespace nipref::fast::internal {

/// An unevaluated sum high + low, |low| below a unit in the last place of high, as large exponents and phases need it.
struct Two {
  double high = 0;
  double low = 0;
};

/// a + b exactly (Knuth).
inline Two two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a b exactly, short of overflow and underflow.
inline Two two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

/// a + b exactly, |a| >= |b| (Dekker).
inline Two two_sum_ordered(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// The error of the following functions is a few times 2^-104 of the largest operand.
inline Two operator+(Two a, Two b) {
  const Two sum = two_sum(a.high, b.high);
  return two_sum_ordered(sum.high, sum.low + (a.low + b.low));
}

inline Two operator-(Two a) { return {-a.high, -a.low}; }

inline Two operator*(Two a, Two b) {
  const Two product = two_product(a.high, b.high);
  if (!std::isfinite(product.high)) return {product.high, 0};
  return two_sum_ordered(product.high, product.low + (a.high * b.low + a.low * b.high));
}

inline Two operator/(Two a, double b) {
  const double quotient = a.high / b;
  if (!std::isfinite(quotient)) return {quotient, 0};
  return two_sum_ordered(quotient, (std::fma(-quotient, b, a.high) + a.low) / b);
}

/// e^-x including the effect of the low word; x >= 0.
inline double decay(Two x) { return std::exp(-x.high) * (1 - x.low); }

}  // namespace nipref::fast::internal
