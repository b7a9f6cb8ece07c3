#pragma once
#include <string>

#include <nipref/fast/number/estimate.hpp>

namespace nipref::verify {

/// A number of a statement with its error. It cannot be made without its error, and arithmetic propagates the error: what the errors of the operands make of the result at most, and rounding, of
/// elementary functions of the library two units in the last place. Where an error leaves the domain of an operation the
/// result's is infinite.
class Propagated {
 public:
  /// A constant of a formula: exact where 40 bits hold it, otherwise the double nearest to a decimal.
  Propagated(double constant);
  Propagated(const fast::Estimate& number) : number_(number) {}
  Propagated(double value, double error) : number_{value, error} {}
  static Propagated exact(double value) { return {value, 0}; }
  static Propagated between(const Propagated& lower, const Propagated& upper);
  static Propagated pi();

  [[nodiscard]] double value() const { return number_.value; }
  [[nodiscard]] double error() const { return number_.error; }
  /// Larger than 0, or smaller, beyond the error.
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

/// What is said of a number: no digit below the first of its error, which grows by the digits left out, in two digits
/// rounded upwards. An exact number is its shortest decimal with the error 0.
struct Stated {
  std::string value, error;
};
Stated stated(const Propagated& number);
/// "0.1234 +- 5.6e-05", and of an exact number the value alone
std::string stated_text(const Propagated& number);

}  // namespace nipref::verify
