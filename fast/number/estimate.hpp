#pragma once
#include <cmath>

namespace nipref::fast {

/// A computed number and an estimate of its error in the same unit: |value - truth| <= error is expected, not
/// proven.
struct Estimate {
  double value;
  double error;
};

/// The product, with its rounding.
inline Estimate operator*(const Estimate& a, const Estimate& b) {
  const double value = a.value * b.value;
  return {value, std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error +
                     0x1p-53 * std::fabs(value)};
}

/// By an exact factor with which the product is exact: a sign, a power of two.
inline Estimate operator*(double factor, const Estimate& number) {
  return {factor * number.value, std::fabs(factor) * number.error};
}

}  // namespace nipref::fast
