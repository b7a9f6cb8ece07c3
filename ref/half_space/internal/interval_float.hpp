#pragma once
#include <nipref/ref/number/internal/float_interval.hpp>
#include <nipref/ref/number/internal/interval_matrix.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>

// Conversions between interval matrices and floating point.

namespace nipref::ref {

struct ComplexMatrix {
  Matrix re, im;
};

inline ComplexMatrix middle(const IntervalMatrix& x) {
  ComplexMatrix result{Matrix(3, 3), Matrix(3, 3)};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto row = static_cast<Matrix::Index>(i);
      const auto column = static_cast<Matrix::Index>(k);
      result.re(row, column) = middle_of(x(i, k).real);
      result.im(row, column) = middle_of(x(i, k).imag);
    }
  }
  return result;
}

}  // namespace nipref::ref
