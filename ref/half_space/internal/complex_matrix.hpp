#pragma once
#include <nipref/ref/number/internal/float_interval.hpp>
#include <nipref/ref/number/internal/interval_matrix.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>

namespace nipref::ref {

/// A complex matrix by its parts.
template <class Scalar>
struct ComplexMatrix {
  DenseMatrix<Scalar> re, im;
};

/// The middle of an interval matrix, to the working precision.
inline ComplexMatrix<Float> middle(const IntervalMatrix& x) {
  ComplexMatrix<Float> result{Matrix(3, 3), Matrix(3, 3)};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto row = static_cast<Matrix::Index>(i), column = static_cast<Matrix::Index>(k);
      result.re(row, column) = middle_of(x(i, k).re);
      result.im(row, column) = middle_of(x(i, k).im);
    }
  }
  return result;
}

}  // namespace nipref::ref
