#include <algorithm>
#include <cmath>
#include <utility>

#include <nipref/ref/number/estimate.hpp>
#include <nipref/ref/number/internal/decimal_text.hpp>

namespace nipref::ref {
namespace {

/// The value with `error` plus the rounding error of the value.
Estimate rounded(Float value, Float error, const Estimate& a, const Estimate& b) {
  Float rounding = zero_of_bits(64);
  mpfr_abs(raw(rounding), raw(value), MPFR_RNDU);
  mpfr_div_2si(raw(rounding), raw(rounding), bits_of(value) - 1, MPFR_RNDU);
  mpfr_add(raw(error), raw(error), raw(rounding), MPFR_RNDU);
  Estimate result(std::move(value), std::move(error), std::max(a.digits, b.digits));
  result.proven = a.proven && b.proven;
  return result;
}

bool is_exactly_zero(const Estimate& x) {
  return x.proven && mpfr_zero_p(raw(x.value)) != 0 && mpfr_zero_p(raw(x.error)) != 0;
}

}  // namespace

Estimate::Estimate(Float the_value, Float the_error, int the_digits)
    : WithError{std::move(the_value), std::move(the_error)}, digits(the_digits) {}

std::string Estimate::value_text() const { return decimal_text(value, digits); }
std::string Estimate::error_text() const { return ref::error_text(value, error, digits); }
double Estimate::to_double() const { return mpfr_get_d(raw(value), MPFR_RNDN); }
double Estimate::error_of(double x) const { return ref::error_of(x, value); }

Estimate operator*(const Estimate& a, const Estimate& b) {
  Float value = zero_of_bits(std::max(bits_of(a.value), bits_of(b.value)) + 64), error = zero_of_bits(64),
        part = zero_of_bits(64);
  mpfr_mul(raw(value), raw(a.value), raw(b.value), MPFR_RNDN);
  mpfr_mul(raw(error), raw(a.error), raw(b.error), MPFR_RNDU);
  for (const auto& [number, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    mpfr_mul(raw(part), raw(number->value), raw(other->error), MPFR_RNDA);
    mpfr_abs(raw(part), raw(part), MPFR_RNDU);
    mpfr_add(raw(error), raw(error), raw(part), MPFR_RNDU);
  }
  Estimate product = rounded(std::move(value), std::move(error), a, b);
  product.proven = product.proven || is_exactly_zero(a) || is_exactly_zero(b);
  return product;
}

Estimate operator-(const Estimate& a, const Estimate& b) {
  Float value = zero_of_bits(std::max(bits_of(a.value), bits_of(b.value)) + 64), error = zero_of_bits(64);
  mpfr_sub(raw(value), raw(a.value), raw(b.value), MPFR_RNDN);
  mpfr_add(raw(error), raw(a.error), raw(b.error), MPFR_RNDU);
  return rounded(std::move(value), std::move(error), a, b);
}

Estimate operator*(double factor, Estimate number) {
  mpfr_mul_d(raw(number.value), raw(number.value), factor, MPFR_RNDN);
  mpfr_mul_d(raw(number.error), raw(number.error), std::fabs(factor), MPFR_RNDU);
  return number;
}

}  // namespace nipref::ref
