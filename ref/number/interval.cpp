#include <algorithm>

#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {
namespace {

template <auto function>
Interval apply(const Interval& x) {
  Interval result(x.precision());
  function(result.get(), x.get());
  return result;
}

template <auto function>
Interval apply(const Interval& x, const Interval& y) {
  Interval result(std::max(x.precision(), y.precision()));
  function(result.get(), x.get(), y.get());
  return result;
}

}  // namespace

Interval Interval::widened(const Interval& radius) const {
  Interval both(precision());
  Float negative = zero_of_bits(radius.precision());
  mpfr_neg(raw(negative), radius.upper(), MPFR_RNDD);
  mpfi_interv_fr(both.get(), raw(negative), radius.upper());
  return *this + both;
}

int sign_of(const Interval& x) { return mpfr_sgn(x.lower()) > 0 ? 1 : mpfr_sgn(x.upper()) < 0 ? -1 : 0; }

Interval operator-(const Interval& x) { return apply<mpfi_neg>(x); }
Interval operator+(const Interval& x, const Interval& y) { return apply<mpfi_add>(x, y); }
Interval operator-(const Interval& x, const Interval& y) { return apply<mpfi_sub>(x, y); }
Interval operator*(const Interval& x, const Interval& y) { return apply<mpfi_mul>(x, y); }
Interval operator/(const Interval& x, const Interval& y) { return apply<mpfi_div>(x, y); }
Interval operator+(const Interval& x, long y) { return x + Interval(y, x.precision()); }
Interval operator-(const Interval& x, long y) { return x - Interval(y, x.precision()); }
Interval operator-(long x, const Interval& y) { return Interval(x, y.precision()) - y; }
Interval operator*(long x, const Interval& y) { return Interval(x, y.precision()) * y; }
Interval operator/(const Interval& x, long y) { return x / Interval(y, x.precision()); }
Interval operator/(long x, const Interval& y) { return Interval(x, y.precision()) / y; }
Interval abs(const Interval& x) { return apply<mpfi_abs>(x); }
Interval exp(const Interval& x) { return apply<mpfi_exp>(x); }
Interval expm1(const Interval& x) { return apply<mpfi_expm1>(x); }
Interval log(const Interval& x) { return apply<mpfi_log>(x); }
Interval log1p(const Interval& x) { return apply<mpfi_log1p>(x); }
Interval sqrt(const Interval& x) { return apply<mpfi_sqrt>(x); }
Interval square(const Interval& x) { return apply<mpfi_sqr>(x); }
Interval cosh(const Interval& x) { return apply<mpfi_cosh>(x); }
Interval sinh(const Interval& x) { return apply<mpfi_sinh>(x); }
Interval sin(const Interval& x) { return apply<mpfi_sin>(x); }
Interval cos(const Interval& x) { return apply<mpfi_cos>(x); }
Interval acos(const Interval& x) { return apply<mpfi_acos>(x); }
Interval atan(const Interval& x) { return apply<mpfi_atan>(x); }

}  // namespace nipref::ref
