#pragma once
#include "ref/interval.hpp"

namespace nipref::ref {

/// A rectangle of the complex plane.
struct ComplexInterval {
  Interval re, im;
};

inline ComplexInterval operator+(const ComplexInterval& x, const ComplexInterval& y) {
  return {x.re + y.re, x.im + y.im};
}
inline ComplexInterval operator-(const ComplexInterval& x, const ComplexInterval& y) {
  return {x.re - y.re, x.im - y.im};
}
inline ComplexInterval operator*(const ComplexInterval& x, const ComplexInterval& y) {
  return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
}
inline ComplexInterval conj(const ComplexInterval& x) { return {x.re, -x.im}; }

}  // namespace nipref::ref
