#pragma once
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// A rectangle that contains a complex number; every operation encloses.
struct ComplexInterval {
  Interval real, imag;
};

ComplexInterval operator+(const ComplexInterval& x, const ComplexInterval& y);
ComplexInterval operator-(const ComplexInterval& x, const ComplexInterval& y);
ComplexInterval operator*(const ComplexInterval& x, const ComplexInterval& y);
ComplexInterval operator-(const ComplexInterval& x);
ComplexInterval operator*(const Interval& x, const ComplexInterval& y);
Interval abs(const ComplexInterval& x);
ComplexInterval conj(const ComplexInterval& x);
/// 1/x; its parts are infinite where x contains 0.
ComplexInterval inverse(const ComplexInterval& x);
ComplexInterval exp(const ComplexInterval& x);
ComplexInterval sin(const ComplexInterval& x);
ComplexInterval cos(const ComplexInterval& x);
/// The same with so many bits, rounded outwards.
ComplexInterval rounded(const ComplexInterval& x, mpfr_prec_t bits);

}  // namespace nipref::ref
