#pragma once
#include <gmpxx.h>

#include <string>
#include <string_view>
#include <utility>

#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// An argument known exactly, as a rational number. The decimal 0.1 and the double 0.1 are different arguments.
class Exact {
 public:
  /// The exact value of a double. `name` is the argument's name in the error message. BadInput unless finite.
  explicit Exact(double value, std::string_view name = "argument");

  /// A rational number in lowest terms, as GMP's arithmetic leaves it.
  explicit Exact(mpq_class value) : value_(std::move(value)) {}

  /// The exact value of decimal ("0.73", "-1e-12") or hexadecimal ("0x1.8p-3") text.
  /// BadInput for anything else, for nan and infinities, and for decimal or binary exponents beyond +-5000.
  static Exact parse(std::string_view text, std::string_view name = "argument");

  [[nodiscard]] const mpq_class& value() const { return value_; }
  [[nodiscard]] int sign() const { return sgn(value_); }
  [[nodiscard]] Exact magnitude() const;
  /// log2 of the magnitude, to 1e-12, also where the nearest double under- or overflows; -infinity for 0.
  [[nodiscard]] double log2_magnitude() const;
  /// Decimal text of 16 significant digits, for messages.
  [[nodiscard]] std::string text() const;
  /// Nearest double, only for messages and for choosing precision, number of terms and the like.
  [[nodiscard]] double approximate() const;

 private:
  mpq_class value_;
};

/// The number rounded to the working precision.
Float to_float(const mpq_class& exact);
inline Float to_float(const Exact& exact) { return to_float(exact.value()); }
/// The number as a rational number, without rounding.
Exact to_exact(const Float& value);

}  // namespace nipref::ref
