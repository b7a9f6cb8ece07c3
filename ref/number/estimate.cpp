#include <algorithm>
#include <cmath>
#include <utility>

#include <nipref/ref/number/estimate.hpp>
#include <nipref/ref/number/internal/decimal_text.hpp>

namespace nipref::ref {
namespace {

/// The value with `error` plus the rounding error of the value.
Estimate rounded(Real value, Real error, const Estimate& a, const Estimate& b) {
  Real rounding(64);
  mpfr_abs(rounding.get(), value.get(), MPFR_RNDU);
  mpfr_div_2si(rounding.get(), rounding.get(), value.precision() - 1, MPFR_RNDU);
  mpfr_add(error.get(), error.get(), rounding.get(), MPFR_RNDU);
  Estimate result(std::move(value), std::move(error), std::max(a.digits, b.digits));
  result.proven = a.proven && b.proven;
  return result;
}

bool is_exactly_zero(const Estimate& x) {
  return x.proven && mpfr_zero_p(x.value.get()) != 0 && mpfr_zero_p(x.error.get()) != 0;
}

}  // namespace

Estimate::Estimate(Real the_value, Real the_error, int the_digits)
    : WithError{std::move(the_value), std::move(the_error)}, digits(the_digits) {}

std::string Estimate::value_text() const { return decimal_text(value, digits); }
std::string Estimate::error_text() const { return ref::error_text(value, error, digits); }
double Estimate::to_double() const { return mpfr_get_d(value.get(), MPFR_RNDN); }
double Estimate::error_of(double x) const { return ref::error_of(x, value); }

Estimate operator*(const Estimate& a, const Estimate& b) {
  Real value(std::max(a.value.precision(), b.value.precision()) + 64), error(64), part(64);
  mpfr_mul(value.get(), a.value.get(), b.value.get(), MPFR_RNDN);
  mpfr_mul(error.get(), a.error.get(), b.error.get(), MPFR_RNDU);
  for (const auto& [number, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    mpfr_mul(part.get(), number->value.get(), other->error.get(), MPFR_RNDA);
    mpfr_abs(part.get(), part.get(), MPFR_RNDU);
    mpfr_add(error.get(), error.get(), part.get(), MPFR_RNDU);
  }
  Estimate product = rounded(std::move(value), std::move(error), a, b);
  product.proven = product.proven || is_exactly_zero(a) || is_exactly_zero(b);
  return product;
}

Estimate operator-(const Estimate& a, const Estimate& b) {
  Real value(std::max(a.value.precision(), b.value.precision()) + 64), error(64);
  mpfr_sub(value.get(), a.value.get(), b.value.get(), MPFR_RNDN);
  mpfr_add(error.get(), a.error.get(), b.error.get(), MPFR_RNDU);
  return rounded(std::move(value), std::move(error), a, b);
}

Estimate operator*(double factor, Estimate number) {
  mpfr_mul_d(number.value.get(), number.value.get(), factor, MPFR_RNDN);
  mpfr_mul_d(number.error.get(), number.error.get(), std::fabs(factor), MPFR_RNDU);
  return number;
}

}  // namespace nipref::ref
