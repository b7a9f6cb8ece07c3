#include <nipref/verify/formulas/propagated.hpp>
#include <nipref/verify/support/internal/number_text.hpp>

namespace nipref::verify {
namespace {

constexpr double half_unit = 0x1p-53, library_rounding = 0x1p-51,
                 infinite = std::numeric_limits<double>::infinity();

/// Makes a number whose error is enlarged by the rounding in the sum of its parts.
Propagated inflated(double value, double error) { return {value, error * (1 + 0x1p-48)}; }

/// The value of a library function, which changes by at most `change` within the error of its argument.
Propagated of_library(double value, double change) {
  return inflated(value, change + library_rounding * std::fabs(value));
}

}  // namespace

Propagated::Propagated(double constant) : number_{constant, half_unit * std::fabs(constant)} {
  int exponent = 0;
  const double scaled = std::ldexp(std::frexp(constant, &exponent), 40);
  if (scaled == std::trunc(scaled)) number_.error = 0;
}

Propagated Propagated::between(const Propagated& lower, const Propagated& upper) {
  const double middle = std::midpoint(lower.number_.value, upper.number_.value);
  const double reach = std::max(middle - lower.number_.value + lower.number_.error,
                                upper.number_.value - middle + upper.number_.error);
  return inflated(middle, reach);
}

Propagated Propagated::pi() { return {std::numbers::pi, half_unit * std::numbers::pi}; }

Propagated operator+(const Propagated& a, const Propagated& b) {
  const double sum = a.value() + b.value(), part = sum - a.value();
  const double rounding = (a.value() - (sum - part)) + (b.value() - part);
  return inflated(sum, a.error() + b.error() + std::fabs(rounding));
}

Propagated operator-(const Propagated& a, const Propagated& b) { return a + -b; }

Propagated operator*(const Propagated& a, const Propagated& b) {
  const double product = a.value() * b.value();
  return inflated(product, std::fabs(a.value()) * b.error() + std::fabs(b.value()) * a.error() +
                               a.error() * b.error() + std::fabs(std::fma(a.value(), b.value(), -product)));
}

Propagated operator/(const Propagated& a, const Propagated& b) {
  const double quotient = a.value() / b.value(), least = std::fabs(b.value()) - b.error();
  if (!(least > 0)) return {quotient, infinite};
  return inflated(quotient, (a.error() + std::fabs(quotient) * b.error() +
                             std::fabs(std::fma(-quotient, b.value(), a.value()))) /
                                least);
}

Propagated fabs(const Propagated& x) { return {std::fabs(x.value()), x.error()}; }
Propagated square(const Propagated& x) { return x * x; }

Propagated sqrt(const Propagated& x) {
  const double root = std::sqrt(x.value()), least = x.value() - x.error();
  if (!(least >= 0)) return {root, infinite};
  if (root == 0) return {0, 0};
  return inflated(root, x.error() / (root + std::sqrt(least)) + half_unit * root);
}

Propagated hypot(const Propagated& x, const Propagated& y) {
  return {std::hypot(x.value(), y.value()), sqrt(x * x + y * y).error()};
}

Propagated exp(const Propagated& x) {
  const double value = std::exp(x.value());
  return of_library(value, value * std::expm1(x.error()));
}

Propagated expm1(const Propagated& x) {
  return of_library(std::expm1(x.value()), std::exp(x.value()) * std::expm1(x.error()));
}

Propagated log(const Propagated& x) {
  const double least = x.value() - x.error();
  if (!(least > 0)) return {std::log(x.value()), infinite};
  return of_library(std::log(x.value()), std::log1p(x.error() / least));
}

Propagated pow(const Propagated& x, const Propagated& exponent) {
  return {std::pow(x.value(), exponent.value()), exp(exponent * log(x)).error()};
}

Propagated sinh(const Propagated& x) {
  return of_library(std::sinh(x.value()), x.error() * std::cosh(std::fabs(x.value()) + x.error()));
}

Propagated cosh(const Propagated& x) {
  return of_library(std::cosh(x.value()), x.error() * std::sinh(std::fabs(x.value()) + x.error()));
}

Propagated tanh(const Propagated& x) { return of_library(std::tanh(x.value()), x.error()); }

Propagated atanh(const Propagated& x) {
  const double farthest = std::fabs(x.value()) + x.error();
  if (!(farthest < 1)) return {std::atanh(x.value()), infinite};
  return of_library(std::atanh(x.value()), x.error() / ((1 - farthest) * (1 + farthest)));
}

Propagated sin(const Propagated& x) { return of_library(std::sin(x.value()), x.error()); }
Propagated cos(const Propagated& x) { return of_library(std::cos(x.value()), x.error()); }
Propagated tan(const Propagated& x) { return sin(x) / cos(x); }
Propagated atan(const Propagated& x) { return of_library(std::atan(x.value()), x.error()); }

Stated stated(const Propagated& number) {
  const double value = number.value();
  if (number.error() == 0) return {fmt::format("{}", value), "0"};
  if (!std::isfinite(number.error())) return {"unknown", "infinite"};
  // A double has no more than 17 significant digits.
  const double error = std::max(number.error(), std::numeric_limits<double>::epsilon() * std::fabs(value));
  const int last = static_cast<int>(std::floor(std::log10(error)));
  const int first = value == 0 ? last : static_cast<int>(std::floor(std::log10(std::fabs(value))));
  const std::string text = first < last ? "0" : fmt::format("{:.{}g}", value, first - last + 1);
  const double left_out = std::fabs(std::strtod(text.c_str(), nullptr) - value);
  return {text, upward_text(error + left_out + half_unit * std::fabs(value))};
}

std::string stated_text(const Propagated& number) {
  const auto [value, error] = stated(number);
  return error == "0" ? value : value + " +- " + error;
}

}  // namespace nipref::verify
