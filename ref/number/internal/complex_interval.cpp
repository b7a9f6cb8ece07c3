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
  return {size * cos(x.imag), size * sin(x.imag)};
}
ComplexInterval sin(const ComplexInterval& x) {
  return {sin(x.real) * cosh(x.imag), cos(x.real) * sinh(x.imag)};
}
ComplexInterval cos(const ComplexInterval& x) {
  return {cos(x.real) * cosh(x.imag), -(sin(x.real) * sinh(x.imag))};
}

}  // namespace nipref::ref
