#pragma once
#include <string>

#include <nipref/fast/number/estimate.hpp>

namespace nipref::verify {

/// A number with an error bound, which arithmetic propagates. The bound of a result covers the errors of the operands
/// and the rounding error; elementary functions of the library are taken to be right to two units in the last place. If
/// the error of an operand leaves the domain of an operation, the bound is infinite.
class Propagated {
 public:
  /// A constant of a formula: exact if 40 bits hold it, otherwise the double nearest to a decimal.
  Propagated(double constant);
  Propagated(const fast::Estimate& number) : number_(number) {}
  Propagated(double value, double error) : number_{value, error} {}
  static Propagated exact(double value) { return {value, 0}; }
  static Propagated between(const Propagated& lower, const Propagated& upper);
  static Propagated pi();

  [[nodiscard]] double value() const { return number_.value; }
  [[nodiscard]] double error() const { return number_.error; }
  /// Whether the number is certainly > 0, or < 0: by more than its error.
  [[nodiscard]] bool is_positive() const { return number_.value > number_.error; }
  [[nodiscard]] bool is_negative() const { return -number_.value > number_.error; }

  Propagated operator-() const { return {-number_.value, number_.error}; }

 private:
  fast::Estimate number_;
};

using OfOne = Propagated(const Propagated& x);
using OfTwo = Propagated(const Propagated& a, const Propagated& b);
OfTwo operator+, operator-, operator*, operator/, hypot;
OfTwo pow;  ///< a > 0
OfOne fabs, square, sqrt, exp, expm1, log, sinh, cosh, tanh, atanh, sin, cos, tan, atan;

/// The decimals of a number and of its error. The number has no digit below the first digit of the error. The error has
/// two digits, rounded upwards, and includes the digits left out. An exact number has its shortest decimal and error 0.
struct Stated {
  std::string value, error;
};
Stated stated(const Propagated& number);
/// "0.1234 +- 5.6e-05"; for an exact number the value alone.
std::string stated_text(const Propagated& number);

}  // namespace nipref::verify
