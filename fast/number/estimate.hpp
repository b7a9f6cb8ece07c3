#pragma once
#include <cmath>

#include <nipref/data/number/with_error.hpp>

namespace nipref::fast {

/// A double and an estimate of its error: |value - truth| <= error is expected, not proven.
struct Estimate : data::WithError<double> {};

/// The product; its error includes the rounding of the product.
inline Estimate operator*(const Estimate& a, const Estimate& b) {
  const double value = a.value * b.value;
  return {value, std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error +
                     0x1p-53 * std::fabs(value)};
}

/// The product with a factor that causes no rounding: a sign or a power of two.
inline Estimate operator*(double factor, const Estimate& number) {
  return {factor * number.value, std::fabs(factor) * number.error};
}

}  // namespace nipref::fast
