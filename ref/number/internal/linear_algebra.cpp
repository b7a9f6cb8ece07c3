#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include <nipref/ref/number/internal/linear_algebra.hpp>

namespace nipref::ref {
namespace {

using Index = std::ptrdiff_t;

template <class Scalar, class Operation>
DenseMatrix<Scalar> entrywise(DenseMatrix<Scalar> x, Operation operation) {
  for (Index i = 0; i < x.size(); ++i) x(i) = operation(x(i), i);
  return x;
}

template <class Scalar>
Index pivot_row(const DenseMatrix<Scalar>& matrix, Index column) {
  using std::abs;
  Index best = column;
  for (Index row = column + 1; row < matrix.rows(); ++row) {
    if (abs(matrix(row, column)) > abs(matrix(best, column))) best = row;
  }
  return best;
}

template <class Scalar>
void swap_rows(DenseMatrix<Scalar>& x, Index a, Index b, Index first_column) {
  for (Index column = first_column; a != b && column < x.columns(); ++column)
    std::swap(x(a, column), x(b, column));
}

/// sum += x y; `product` is room for it, so that there is no new number for each.
void add_product(double& sum, double x, double y, double& /*product*/) { sum += x * y; }
void add_product(Float& sum, const Float& x, const Float& y, Float& product) {
  mpfr_mul(raw(product), raw(x), raw(y), MPFR_RNDN);
  mpfr_add(raw(sum), raw(sum), raw(product), MPFR_RNDN);
}

template <class Scalar>
void subtract_row(DenseMatrix<Scalar>& x, Index row, const Scalar& factor, Index other, Index first_column) {
  for (Index column = first_column; column < x.columns(); ++column)
    x(row, column) -= factor * x(other, column);
}

/// Without a number for each product.
template <>
void subtract_row(Matrix& x, Matrix::Index row, const Float& factor, Matrix::Index other,
                  Matrix::Index first_column) {
  Float product;
  for (Matrix::Index column = first_column; column < x.columns(); ++column) {
    mpfr_mul(raw(product), raw(factor), raw(x(other, column)), MPFR_RNDN);
    mpfr_sub(raw(x(row, column)), raw(x(row, column)), raw(product), MPFR_RNDN);
  }
}

template <class Scalar>
Scalar squared_off_diagonal(const DenseMatrix<Scalar>& x) {
  Scalar sum = 0;
  for (Index q = 1; q < x.rows(); ++q) {
    for (Index p = 0; p < q; ++p) sum += x(p, q) * x(p, q);
  }
  return sum;
}

/// Columns p and q turned into each other.
template <class Scalar>
void turn_columns(DenseMatrix<Scalar>& x, Index p, Index q, const Scalar& cosine, const Scalar& sine) {
  for (Index i = 0; i < x.rows(); ++i) {
    const Scalar xp = x(i, p), xq = x(i, q);
    x(i, p) = cosine * xp - sine * xq;
    x(i, q) = sine * xp + cosine * xq;
  }
}

/// Makes the entry at p, q of a symmetric matrix 0.
template <class Scalar>
void rotate(DenseMatrix<Scalar>& matrix, DenseMatrix<Scalar>& vectors, Index p, Index q) {
  using std::abs, std::sqrt;
  if (matrix(p, q) == 0) return;
  const Scalar cotangent = (matrix(q, q) - matrix(p, p)) / (2 * matrix(p, q));  // of twice the angle
  const Scalar size = 1 / (abs(cotangent) + sqrt(1 + cotangent * cotangent));
  const Scalar tangent = cotangent < 0 ? -size : size;
  const Scalar cosine = 1 / sqrt(1 + tangent * tangent);
  const Scalar sine = tangent * cosine;
  turn_columns(matrix, p, q, cosine, sine);
  matrix = matrix.transpose();
  turn_columns(matrix, p, q, cosine, sine);
  matrix(p, q) = matrix(q, p) = 0;
  turn_columns(vectors, p, q, cosine, sine);
}

}  // namespace

template <class Scalar>
DenseMatrix<Scalar> DenseMatrix<Scalar>::identity(Index size) {
  DenseMatrix result(size, size);
  for (Index i = 0; i < size; ++i) result(i, i) = 1;
  return result;
}

template <class Scalar>
DenseMatrix<Scalar> DenseMatrix<Scalar>::block(Index row, Index column, Index rows, Index columns) const {
  DenseMatrix result(rows, columns);
  for (Index k = 0; k < columns; ++k) {
    for (Index i = 0; i < rows; ++i) result(i, k) = (*this)(row + i, column + k);
  }
  return result;
}

template <class Scalar>
void DenseMatrix<Scalar>::set_block(Index row, Index column, const DenseMatrix& block) {
  for (Index k = 0; k < block.columns(); ++k) {
    for (Index i = 0; i < block.rows(); ++i) (*this)(row + i, column + k) = block(i, k);
  }
}

template <class Scalar>
DenseMatrix<Scalar> DenseMatrix<Scalar>::transpose() const {
  DenseMatrix result(columns_, rows_);
  for (Index k = 0; k < columns_; ++k) {
    for (Index i = 0; i < rows_; ++i) result(k, i) = (*this)(i, k);
  }
  return result;
}

template <class Scalar>
DenseMatrix<Scalar> DenseMatrix<Scalar>::inverse() const {
  return solve(*this, identity(rows_));
}

template <class Scalar>
DenseMatrix<Scalar> DenseMatrix<Scalar>::operator-() const {
  return entrywise(*this, [](const Scalar& x, Index) -> Scalar { return -x; });
}

template <class Scalar>
DenseMatrix<Scalar> DenseMatrix<Scalar>::operator+(const DenseMatrix& y) const {
  return entrywise(*this, [&](const Scalar& x, Index i) -> Scalar { return x + y(i); });
}

template <class Scalar>
DenseMatrix<Scalar> DenseMatrix<Scalar>::operator-(const DenseMatrix& y) const {
  return entrywise(*this, [&](const Scalar& x, Index i) -> Scalar { return x - y(i); });
}

template <class Scalar>
DenseMatrix<Scalar> DenseMatrix<Scalar>::operator*(const Scalar& factor) const {
  return entrywise(*this, [&](const Scalar& x, Index) -> Scalar { return factor * x; });
}

template <class Scalar>
DenseMatrix<Scalar> DenseMatrix<Scalar>::operator/(const Scalar& divisor) const {
  return entrywise(*this, [&](const Scalar& x, Index) -> Scalar { return x / divisor; });
}

template <class Scalar>
DenseMatrix<Scalar> DenseMatrix<Scalar>::operator*(const DenseMatrix& y) const {
  DenseMatrix result(rows_, y.columns_);
  Scalar product = 0;
  for (Index k = 0; k < y.columns_; ++k) {
    for (Index j = 0; j < columns_; ++j) {
      for (Index i = 0; i < rows_; ++i) add_product(result(i, k), (*this)(i, j), y(j, k), product);
    }
  }
  return result;
}

template <class Scalar>
Scalar dot(const DenseMatrix<Scalar>& x, const DenseMatrix<Scalar>& y) {
  Scalar sum = 0;
  for (Index i = 0; i < x.size(); ++i) sum += x(i) * y(i);
  return sum;
}

template <class Scalar>
Scalar squared_norm(const DenseMatrix<Scalar>& x) {
  return dot(x, x);
}

Float norm(const Matrix& x) { return sqrt(squared_norm(x)); }

Float largest_entry(const Matrix& x) {
  Float largest = 0;
  for (Index i = 0; i < x.size(); ++i) {
    const Float size = abs(x(i));
    if (!(size == size)) return size;
    largest = std::max(largest, size);
  }
  return largest;
}

DenseMatrix<double> in_double(const Matrix& x) {
  DenseMatrix<double> result(x.rows(), x.columns());
  for (Index i = 0; i < x.size(); ++i) result(i) = static_cast<double>(x(i));
  return result;
}

template <class Scalar>
DenseMatrix<Scalar> solve(DenseMatrix<Scalar> matrix, DenseMatrix<Scalar> right) {
  const Index size = matrix.rows();
  for (Index k = 0; k < size; ++k) {
    const Index pivot = pivot_row(matrix, k);
    swap_rows(matrix, k, pivot, k);
    swap_rows(right, k, pivot, 0);
    for (Index row = k + 1; row < size; ++row) {
      const Scalar factor = matrix(row, k) / matrix(k, k);
      subtract_row(matrix, row, factor, k, k + 1);
      subtract_row(right, row, factor, k, 0);
    }
  }
  for (Index k = size - 1; k >= 0; --k) {
    for (Index column = 0; column < right.columns(); ++column) right(k, column) /= matrix(k, k);
    for (Index row = 0; row < k; ++row) subtract_row(right, row, matrix(row, k), k, 0);
  }
  return right;
}

void factor_positive(DenseMatrix<double>& matrix) {
  const Index size = matrix.rows();
  for (Index k = 0; k < size; ++k) {
    const double diagonal = std::sqrt(matrix(k, k));
    for (Index i = k; i < size; ++i) matrix(i, k) /= diagonal;
    for (Index column = k + 1; column < size; ++column) {
      const double factor = matrix(column, k);
      for (Index i = column; i < size; ++i) matrix(i, column) -= factor * matrix(i, k);
    }
  }
}

void solve_factored(const DenseMatrix<double>& factor, DenseMatrix<double>& right) {
  const Index size = factor.rows();
  for (Index k = 0; k < size; ++k) {
    right(k) /= factor(k, k);
    for (Index i = k + 1; i < size; ++i) right(i) -= factor(i, k) * right(k);
  }
  for (Index k = size - 1; k >= 0; --k) {
    for (Index i = k + 1; i < size; ++i) right(k) -= factor(i, k) * right(i);
    right(k) /= factor(k, k);
  }
}

template <class Scalar>
SymmetricEigen<Scalar> symmetric_eigen(DenseMatrix<Scalar> matrix) {
  const Index size = matrix.rows();
  const Scalar unit = std::numeric_limits<Scalar>::epsilon();
  const Scalar negligible = unit * unit * squared_norm(matrix);
  DenseMatrix<Scalar> vectors = DenseMatrix<Scalar>::identity(size);
  Scalar before = 0, off_diagonal = squared_off_diagonal(matrix);
  do {  // until what is left is rounding, at the latest when a sweep no longer makes it smaller
    before = off_diagonal;
    for (Index q = 1; q < size; ++q) {
      for (Index p = 0; p < q; ++p) rotate(matrix, vectors, p, q);
    }
    off_diagonal = squared_off_diagonal(matrix);
  } while (off_diagonal > negligible && off_diagonal < before);

  std::vector<Index> order(static_cast<std::size_t>(size));
  std::iota(order.begin(), order.end(), Index(0));
  std::ranges::sort(order, std::less(), [&](Index k) { return matrix(k, k); });
  SymmetricEigen<Scalar> result{DenseMatrix<Scalar>(size), DenseMatrix<Scalar>(size, size)};
  for (Index k = 0; k < size; ++k) {
    const Index from = order[static_cast<std::size_t>(k)];
    result.values(k) = matrix(from, from);
    result.vectors.set_block(0, k, vectors.column(from));
  }
  return result;
}

template class DenseMatrix<Float>;
template Float dot(const Matrix& x, const Matrix& y);
template Float squared_norm(const Matrix& x);
template Matrix solve(Matrix matrix, Matrix right);
template SymmetricEigen<Float> symmetric_eigen(Matrix matrix);

template class DenseMatrix<double>;
template double dot(const DenseMatrix<double>& x, const DenseMatrix<double>& y);
template double squared_norm(const DenseMatrix<double>& x);
template SymmetricEigen<double> symmetric_eigen(DenseMatrix<double> matrix);

}  // namespace nipref::ref
