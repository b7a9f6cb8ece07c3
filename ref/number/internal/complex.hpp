#pragma once
#include <utility>

#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

inline Float zero_like(const Float& /*x*/) { return 0; }
inline Interval zero_like(const Interval& x) { return Interval(x.precision()); }
inline Float square(const Float& x) { return x * x; }
inline mpq_class zero_like(const mpq_class& /*x*/) { return 0; }
inline mpq_class square(const mpq_class& x) { return x * x; }

/// A complex number. With rational parts, operations are exact. With Float parts, products and quotients are computed
/// by their formulas, so that rounding errors are small relative to the modulus, not to each part. With intervals as
/// parts, it is a rectangle that contains a complex number, and the result of every operation contains the true result.
template <class Number>
struct Complex {
  Number re, im;

  Complex() = default;  ///< 0; not for intervals
  Complex(Number real) : re(std::move(real)), im(zero_like(re)) {}
  Complex(Number real, Number imaginary) : re(std::move(real)), im(std::move(imaginary)) {}

  [[nodiscard]] bool is_real() const { return im == 0; }  ///< not for intervals
  friend Complex operator-(const Complex& x) { return {-x.re, -x.im}; }
  friend Complex operator+(const Complex& x, const Complex& y) { return {x.re + y.re, x.im + y.im}; }
  friend Complex operator-(const Complex& x, const Complex& y) { return {x.re - y.re, x.im - y.im}; }
  friend Complex operator*(const Complex& x, const Complex& y) {
    return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
  }
  friend Complex operator*(const Number& x, const Complex& y) { return {x * y.re, x * y.im}; }
  friend Complex operator*(const Complex& x, const Number& y) { return {x.re * y, x.im * y}; }
  friend Complex operator/(const Complex& x, const Number& y) { return {x.re / y, x.im / y}; }
  friend Complex operator/(const Complex& x, const Complex& y) {
    return y.is_real() ? x / y.re : x * conj(y) / (square(y.re) + square(y.im));
  }
  friend Complex conj(const Complex& x) { return {x.re, -x.im}; }
};
using ComplexFloat = Complex<Float>;
using ComplexInterval = Complex<Interval>;

inline Float abs(const ComplexFloat& x) { return hypot(x.re, x.im); }
inline Interval abs(const ComplexInterval& x) { return sqrt(square(x.re) + square(x.im)); }
/// 1/x; its parts are infinite where x contains 0.
inline ComplexInterval inverse(const ComplexInterval& x) { return conj(x) / (square(x.re) + square(x.im)); }
inline ComplexFloat exp(const ComplexFloat& x) {
  const Float size = exp(x.re);
  return x.is_real() ? ComplexFloat(size) : ComplexFloat(size * cos(x.im), size * sin(x.im));
}
inline ComplexInterval exp(const ComplexInterval& x) {
  const Interval size = exp(x.re);
  if (mpfi_is_zero(x.im.get()) > 0) return {size, x.im};
  // The sine and the cosine of the angle's middle are widened by the angle's half-width, because their slopes are at
  // most 1. This takes half the time of MPFI's sine and cosine.
  const mpfr_prec_t bits = x.im.precision();
  Float angle = zero_of_bits(bits), cosine = angle, sine = angle;
  mpfi_mid(raw(angle), x.im.get());
  mpfr_sin_cos(raw(sine), raw(cosine), raw(angle), MPFR_RNDN);
  const Interval off = magnitude_of(x.im - interval_of(angle));
  const auto around = [&](Float& below) {
    Float above = below;
    mpfr_nextbelow(raw(below));
    mpfr_nextabove(raw(above));
    return Interval(below, above, bits).widened(off);
  };
  return {size * around(cosine), size * around(sine)};
}
template <class Number>
Complex<Number> sin(const Complex<Number>& x) {
  return {sin(x.re) * cosh(x.im), cos(x.re) * sinh(x.im)};
}
template <class Number>
Complex<Number> cos(const Complex<Number>& x) {
  return {cos(x.re) * cosh(x.im), -(sin(x.re) * sinh(x.im))};
}
/// The principal value.
inline ComplexFloat log(const ComplexFloat& x) { return {log(abs(x)), atan2(x.im, x.re)}; }
/// x with a precision of `bits` bits, rounded outwards.
inline ComplexInterval rounded(const ComplexInterval& x, mpfr_prec_t bits) {
  ComplexInterval result{Interval(bits), Interval(bits)};
  mpfi_set(result.re.get(), x.re.get());
  mpfi_set(result.im.get(), x.im.get());
  return result;
}

}  // namespace nipref::ref
