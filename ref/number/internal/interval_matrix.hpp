#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include <nipref/ref/number/internal/complex.hpp>

namespace nipref::ref {

/// A complex 3x3 matrix of intervals; every operation encloses.
class IntervalMatrix {
 public:
  IntervalMatrix(const std::function<ComplexInterval(std::size_t row, std::size_t column)>& entry);

  /// Float entries.
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

/// The upper end bounds the row-sum norm, which for Hermitian matrices bounds the spectral norm.
Interval norm_bound(const IntervalMatrix& x);

}  // namespace nipref::ref
