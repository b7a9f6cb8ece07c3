#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include <nipref/ref/number/internal/complex.hpp>

namespace nipref::ref {

/// A complex 3x3 matrix of intervals. The result of every operation contains the true result.
class IntervalMatrix {
 public:
  IntervalMatrix(const std::function<ComplexInterval(std::size_t row, std::size_t column)>& entry);

  /// A matrix of real entries.
  static IntervalMatrix real(const std::function<Interval(std::size_t row, std::size_t column)>& entry);

  [[nodiscard]] const ComplexInterval& operator()(std::size_t row, std::size_t column) const {
    return entries_[3 * row + column];
  }
  [[nodiscard]] mpfr_prec_t precision() const { return entries_[0].re.precision(); }

  [[nodiscard]] IntervalMatrix adjoint() const;

 private:
  std::vector<ComplexInterval> entries_;
};

IntervalMatrix operator+(const IntervalMatrix& x, const IntervalMatrix& y);
IntervalMatrix operator-(const IntervalMatrix& x, const IntervalMatrix& y);
IntervalMatrix operator*(const IntervalMatrix& x, const IntervalMatrix& y);

/// i x.
IntervalMatrix times_i(const IntervalMatrix& x);

/// Determinant and inverse of Hermitian matrices.
Interval hermitian_determinant(const IntervalMatrix& x);
IntervalMatrix hermitian_inverse(const IntervalMatrix& x);

/// Whether every Hermitian matrix within x is positive definite; false where that is not proven.
bool is_positive_definite(const IntervalMatrix& x);

/// An interval whose upper end bounds the row-sum norm, and with it the spectral norm of a Hermitian matrix.
Interval norm_bound(const IntervalMatrix& x);

}  // namespace nipref::ref
