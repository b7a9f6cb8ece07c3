#include <nipref/ref/number/internal/interval_matrix.hpp>

namespace nipref::ref {
namespace {

Interval squared_magnitude(const ComplexInterval& x) { return square(x.re) + square(x.im); }

/// The minor of x that leaves out one row and one column.
ComplexInterval minor_of(const IntervalMatrix& x, std::size_t row, std::size_t column) {
  const std::size_t r0 = row == 0 ? 1 : 0;
  const std::size_t r1 = row == 2 ? 1 : 2;
  const std::size_t c0 = column == 0 ? 1 : 0;
  const std::size_t c1 = column == 2 ? 1 : 2;
  return x(r0, c0) * x(r1, c1) - x(r0, c1) * x(r1, c0);
}

Interval leading_minor(const IntervalMatrix& x) {
  return x(0, 0).re * x(1, 1).re - squared_magnitude(x(0, 1));
}

}  // namespace

IntervalMatrix::IntervalMatrix(
    const std::function<ComplexInterval(std::size_t row, std::size_t column)>& entry) {
  entries_.reserve(9);
  for (std::size_t k = 0; k < 9; ++k) entries_.push_back(entry(k / 3, k % 3));
}

IntervalMatrix IntervalMatrix::real(
    const std::function<Interval(std::size_t row, std::size_t column)>& entry) {
  return {[&](std::size_t i, std::size_t k) {
    Interval re = entry(i, k);
    const mpfr_prec_t precision = re.precision();
    return ComplexInterval{std::move(re), Interval(precision)};
  }};
}

IntervalMatrix IntervalMatrix::adjoint() const {
  return {[&](std::size_t i, std::size_t k) { return conj((*this)(k, i)); }};
}

IntervalMatrix operator+(const IntervalMatrix& x, const IntervalMatrix& y) {
  return {[&](std::size_t i, std::size_t k) { return x(i, k) + y(i, k); }};
}
IntervalMatrix operator-(const IntervalMatrix& x, const IntervalMatrix& y) {
  return {[&](std::size_t i, std::size_t k) { return x(i, k) - y(i, k); }};
}
IntervalMatrix operator*(const IntervalMatrix& x, const IntervalMatrix& y) {
  return {[&](std::size_t i, std::size_t k) {
    return x(i, 0) * y(0, k) + x(i, 1) * y(1, k) + x(i, 2) * y(2, k);
  }};
}

IntervalMatrix times_i(const IntervalMatrix& x) {
  return {[&](std::size_t i, std::size_t k) { return ComplexInterval{-x(i, k).im, x(i, k).re}; }};
}

Interval hermitian_determinant(const IntervalMatrix& x) {
  const ComplexInterval cycle = x(0, 1) * x(1, 2) * x(2, 0);
  return leading_minor(x) * x(2, 2).re + 2 * cycle.re - x(0, 0).re * squared_magnitude(x(1, 2)) -
         x(1, 1).re * squared_magnitude(x(0, 2));
}

IntervalMatrix hermitian_inverse(const IntervalMatrix& x) {
  const Interval determinant = hermitian_determinant(x);
  return {[&](std::size_t i, std::size_t k) {
    const ComplexInterval minor = minor_of(x, k, i);
    const Interval scale = (i + k) % 2 == 0 ? determinant : -determinant;
    return ComplexInterval{minor.re / scale, minor.im / scale};
  }};
}

bool is_positive_definite(const IntervalMatrix& x) {
  return sign_of(x(0, 0).re) > 0 && sign_of(leading_minor(x)) > 0 && sign_of(hermitian_determinant(x)) > 0;
}

Interval norm_bound(const IntervalMatrix& x) {
  Interval largest(x.precision());
  for (std::size_t i = 0; i < 3; ++i) {
    Interval sum(x.precision());
    for (std::size_t k = 0; k < 3; ++k) sum = sum + magnitude_of(x(i, k).re) + magnitude_of(x(i, k).im);
    largest = larger_of(largest, sum);
  }
  return largest;
}

}  // namespace nipref::ref
