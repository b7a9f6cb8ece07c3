#pragma once
#include <string>

#include <nipref/data/number/with_error.hpp>
#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// A number, its error (>= 0), and the significant digits that the caller asked for. If `proven` is true, the error is
/// a proven bound, see Enclosure. Otherwise it is an estimate, meant to exceed |value - truth| with a margin.
struct Estimate : data::WithError<Float> {
  int digits;
  bool proven = false;

  Estimate(Float the_value, Float the_error, int the_digits);

  /// Decimal text of the value. It has three significant digits more than were asked for, and as many more as the
  /// value has before the point.
  [[nodiscard]] std::string value_text() const;
  /// The error plus the rounding error of value_text(), rounded up to two significant digits: "1.2e-53".
  [[nodiscard]] std::string error_text() const;
  /// Nearest double.
  [[nodiscard]] double to_double() const;
  /// x - value, formed exactly and rounded once: the error of an approximation x.
  [[nodiscard]] double error_of(double x) const;
};

// The `digits` of a result are the larger of those of its operands. A result is proven if both operands are proven. A
// product is also proven if one factor is exactly 0.

/// The product and the difference; their errors include the rounding errors of the operation.
Estimate operator*(const Estimate& a, const Estimate& b);
Estimate operator-(const Estimate& a, const Estimate& b);
/// The exact product with a factor that is a sign or a power of two.
Estimate operator*(double factor, Estimate number);

}  // namespace nipref::ref
