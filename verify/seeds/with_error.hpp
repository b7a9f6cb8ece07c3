#pragma once
#include <string>

#include <nipref/fast/number/estimate.hpp>

namespace nipref::verify {

/// A number of a statement: a double, and by how much the truth may differ from it. It cannot be made without its error,
/// and arithmetic carries the error on: what the errors of the operands make of the result at most, and rounding, of
/// elementary functions of the library two units in the last place. Where an error leaves the domain of an operation the
/// result's is infinite.
class WithError {
 public:
  /// A constant of a formula: exact where 40 bits hold it, otherwise the double nearest to a decimal.
  WithError(double constant);
  WithError(const fast::Estimate& number) : WithError(number.value, number.error) {}
  WithError(double the_value, double the_error) : value_(the_value), error_(the_error) {}
  static WithError exact(double value) { return {value, 0}; }
  static WithError between(const WithError& lower, const WithError& upper);
  static WithError pi();

  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] double error() const { return error_; }
  /// Larger than 0, or smaller, beyond the error.
  [[nodiscard]] bool is_positive() const { return value_ > error_; }
  [[nodiscard]] bool is_negative() const { return -value_ > error_; }

  WithError operator-() const { return {-value_, error_}; }

 private:
  double value_, error_;
};

WithError operator+(const WithError& a, const WithError& b);
WithError operator-(const WithError& a, const WithError& b);
WithError operator*(const WithError& a, const WithError& b);
WithError operator/(const WithError& a, const WithError& b);
WithError fabs(const WithError& x);
WithError square(const WithError& x);
WithError sqrt(const WithError& x);
WithError hypot(const WithError& x, const WithError& y);
WithError exp(const WithError& x);
WithError expm1(const WithError& x);
WithError log(const WithError& x);
WithError pow(const WithError& x, const WithError& exponent);  ///< x > 0
WithError sinh(const WithError& x);
WithError cosh(const WithError& x);
WithError tanh(const WithError& x);
WithError atanh(const WithError& x);
WithError sin(const WithError& x);
WithError cos(const WithError& x);
WithError tan(const WithError& x);
WithError atan(const WithError& x);

/// What is said of a number: no digit below the first of its error, which grows by the digits left out, in two digits
/// rounded upwards. An exact number is its shortest decimal with the error 0.
struct Stated {
  std::string value, error;
};
Stated stated(const WithError& number);
/// "0.1234 +- 5.6e-05", and of an exact number the value alone
std::string stated_text(const WithError& number);

}  // namespace nipref::verify
