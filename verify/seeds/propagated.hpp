#pragma once
#include <string>

#include <nipref/fast/number/estimate.hpp>

namespace nipref::verify {

/// A number with a bound on its error, which arithmetic propagates: the bound of a result covers the errors of the operands
/// and rounding, for which elementary functions of the library are given two units in the last place. Where an operand's
/// error leaves the domain of an operation the bound is infinite.
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
  /// Certainly larger than 0, or smaller: by more than the error.
  [[nodiscard]] bool is_positive() const { return number_.value > number_.error; }
  [[nodiscard]] bool is_negative() const { return -number_.value > number_.error; }

  Propagated operator-() const { return {-number_.value, number_.error}; }

 private:
  fast::Estimate number_;
};

Propagated operator+(const Propagated& a, const Propagated& b);
Propagated operator-(const Propagated& a, const Propagated& b);
Propagated operator*(const Propagated& a, const Propagated& b);
Propagated operator/(const Propagated& a, const Propagated& b);
Propagated fabs(const Propagated& x);
Propagated square(const Propagated& x);
Propagated sqrt(const Propagated& x);
Propagated hypot(const Propagated& x, const Propagated& y);
Propagated exp(const Propagated& x);
Propagated expm1(const Propagated& x);
Propagated log(const Propagated& x);
Propagated pow(const Propagated& x, const Propagated& exponent);  ///< x > 0
Propagated sinh(const Propagated& x);
Propagated cosh(const Propagated& x);
Propagated tanh(const Propagated& x);
Propagated atanh(const Propagated& x);
Propagated sin(const Propagated& x);
Propagated cos(const Propagated& x);
Propagated tan(const Propagated& x);
Propagated atan(const Propagated& x);

/// The decimals of a number and of its error. The number has no digit below the first of its error; the error includes the
/// digits left out and has two digits, rounded upwards. An exact number has its shortest decimal and the error 0.
struct Stated {
  std::string value, error;
};
Stated stated(const Propagated& number);
/// "0.1234 +- 5.6e-05", and of an exact number the value alone
std::string stated_text(const Propagated& number);

}  // namespace nipref::verify
