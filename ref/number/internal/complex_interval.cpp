#include <nipref/ref/number/internal/complex_interval.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>

namespace nipref::ref {

ComplexInterval operator+(const ComplexInterval& x, const ComplexInterval& y) {
  return {x.real + y.real, x.imag + y.imag};
}
ComplexInterval operator-(const ComplexInterval& x, const ComplexInterval& y) {
  return {x.real - y.real, x.imag - y.imag};
}
ComplexInterval operator*(const ComplexInterval& x, const ComplexInterval& y) {
  return {x.real * y.real - x.imag * y.imag, x.real * y.imag + x.imag * y.real};
}
ComplexInterval operator-(const ComplexInterval& x) { return {-x.real, -x.imag}; }
ComplexInterval operator*(const Interval& x, const ComplexInterval& y) { return {x * y.real, x * y.imag}; }
Interval abs(const ComplexInterval& x) { return sqrt(square(x.real) + square(x.imag)); }
ComplexInterval conj(const ComplexInterval& x) { return {x.real, -x.imag}; }
ComplexInterval inverse(const ComplexInterval& x) {
  const Interval size = square(x.real) + square(x.imag);
  return {x.real / size, -(x.imag / size)};
}
ComplexInterval exp(const ComplexInterval& x) {
  const Interval size = exp(x.real);
  if (mpfi_is_zero(x.imag.get()) > 0) return {size, x.imag};
  // Those of the middle of the angle, which change no more than it does, take half the time of MPFI's.
  const mpfr_prec_t bits = x.imag.precision();
  Float angle = zero_of_bits(bits), cosine = angle, sine = angle;
  mpfi_mid(raw(angle), x.imag.get());
  mpfr_sin_cos(raw(sine), raw(cosine), raw(angle), MPFR_RNDN);
  const Interval off = magnitude_of(x.imag - interval_of(angle));
  const auto around = [&](Float& below) {
    Float above = below;
    mpfr_nextbelow(raw(below));
    mpfr_nextabove(raw(above));
    return Interval(below, above, bits).widened(off);
  };
  return {size * around(cosine), size * around(sine)};
}
ComplexInterval sin(const ComplexInterval& x) {
  return {sin(x.real) * cosh(x.imag), cos(x.real) * sinh(x.imag)};
}
ComplexInterval cos(const ComplexInterval& x) {
  return {cos(x.real) * cosh(x.imag), -(sin(x.real) * sinh(x.imag))};
}

ComplexInterval rounded(const ComplexInterval& x, mpfr_prec_t bits) {
  ComplexInterval result{Interval(bits), Interval(bits)};
  mpfi_set(result.real.get(), x.real.get());
  mpfi_set(result.imag.get(), x.imag.get());
  return result;
}

}  // namespace nipref::ref
