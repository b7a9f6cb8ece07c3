#include <nipref/ref/number/internal/complex_interval.hpp>

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
ComplexInterval conj(const ComplexInterval& x) { return {x.real, -x.imag}; }
ComplexInterval inverse(const ComplexInterval& x) {
  const Interval size = square(x.real) + square(x.imag);
  return {x.real / size, -(x.imag / size)};
}

}  // namespace nipref::ref
