#pragma once
#include <utility>

#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// A complex number of two Floats. Products and quotients are computed by their formulas, so that their rounding errors
/// are relative to the modulus, not to each part.
struct ComplexFloat {
  Float re = 0, im = 0;

  ComplexFloat() = default;
  ComplexFloat(Float real, Float imaginary = 0) : re(std::move(real)), im(std::move(imaginary)) {}

  [[nodiscard]] bool is_real() const { return im == 0; }
  friend ComplexFloat operator-(const ComplexFloat& x) { return {-x.re, -x.im}; }
  friend ComplexFloat operator+(const ComplexFloat& x, const ComplexFloat& y) {
    return {x.re + y.re, x.im + y.im};
  }
  friend ComplexFloat operator-(const ComplexFloat& x, const ComplexFloat& y) {
    return {x.re - y.re, x.im - y.im};
  }
  friend ComplexFloat operator*(const ComplexFloat& x, const ComplexFloat& y) {
    return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
  }
  friend ComplexFloat operator*(const ComplexFloat& x, const Float& y) { return {x.re * y, x.im * y}; }
  friend ComplexFloat operator/(const ComplexFloat& x, const Float& y) { return {x.re / y, x.im / y}; }
  friend ComplexFloat operator/(const ComplexFloat& x, const ComplexFloat& y) {
    if (y.is_real()) return x / y.re;
    return x * ComplexFloat(y.re, -y.im) / (y.re * y.re + y.im * y.im);
  }
};

inline Float abs(const ComplexFloat& x) { return hypot(x.re, x.im); }
inline ComplexFloat exp(const ComplexFloat& x) {
  const Float size = exp(x.re);
  return x.is_real() ? ComplexFloat(size) : ComplexFloat(size * cos(x.im), size * sin(x.im));
}
/// The principal value.
inline ComplexFloat log(const ComplexFloat& x) {
  Float angle;
  mpfr_atan2(raw(angle), raw(x.im), raw(x.re), MPFR_RNDN);
  return {log(abs(x)), std::move(angle)};
}

}  // namespace nipref::ref
