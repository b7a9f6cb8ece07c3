#pragma once
#include <string>

#include <nipref/data/number/with_error.hpp>
#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// A number of the reference, its error (>= 0), and the digits that were asked for. An estimated error is meant to
/// cover the truth with a margin; where the error is proven, see Enclosure, `proven` is true.
struct Estimate : data::WithError<Float> {
  int digits;
  bool proven = false;

  Estimate(Float the_value, Float the_error, int the_digits);

  /// Decimal text of the value, three significant digits more than were asked for (and as many more as the
  /// value has before the point).
  [[nodiscard]] std::string value_text() const;
  /// The error and what rounding the value to value_text() adds to it, two significant digits, rounded up: "1.2e-53".
  [[nodiscard]] std::string error_text() const;
  /// Nearest double.
  [[nodiscard]] double to_double() const;
  /// x - value, formed exactly and rounded once: the error of an approximation x.
  [[nodiscard]] double error_of(double x) const;
};

// What follows has the larger number of digits of its two terms. It is proven if both are, and if a factor is exactly
// 0.

/// The product and the difference, with their rounding.
Estimate operator*(const Estimate& a, const Estimate& b);
Estimate operator-(const Estimate& a, const Estimate& b);
/// The product with a factor for which it is exact, which is a sign or a power of two.
Estimate operator*(double factor, Estimate number);

}  // namespace nipref::ref
