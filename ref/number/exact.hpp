#pragma once
#include <gmpxx.h>

#include <string>
#include <string_view>
#include <utility>

#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// An argument known exactly, as a rational number: the decimal 0.1 and the double 0.1 are different
/// arguments.
class Exact {
 public:
  /// The value of a double, exactly. `name` is the argument's name for the error; BadInput unless finite.
  explicit Exact(double value, std::string_view name = "argument");

  /// A rational number in lowest terms, as GMP's arithmetic leaves it.
  explicit Exact(mpq_class value) : value_(std::move(value)) {}

  /// Decimal ("0.73", "-1e-12") or hexadecimal ("0x1.8p-3") text, exactly.
  /// BadInput for anything else, for nan and infinities, and for decimal or binary exponents beyond +-5000.
  static Exact parse(std::string_view text, std::string_view name = "argument");

  [[nodiscard]] const mpq_class& value() const { return value_; }
  [[nodiscard]] int sign() const { return sgn(value_); }
  [[nodiscard]] Exact magnitude() const;
  /// log2 of the magnitude, to 1e-12; -infinity for 0. Good where the double under- or overflows.
  [[nodiscard]] double log2_magnitude() const;
  /// Decimal text of 16 significant digits, for messages.
  [[nodiscard]] std::string text() const;
  /// Nearest double, for choosing the work and for messages only.
  [[nodiscard]] double approximate() const;

 private:
  mpq_class value_;
};

/// Rounded to the working precision.
Float to_float(const mpq_class& exact);
inline Float to_float(const Exact& exact) { return to_float(exact.value()); }
/// Exactly.
Exact to_exact(const Float& value);

}  // namespace nipref::ref
