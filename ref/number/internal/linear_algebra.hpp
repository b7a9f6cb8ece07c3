#pragma once
#include <cstddef>
#include <vector>

#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// A dense matrix of Float or double, by columns; a vector is one of a single column. Shapes that do not fit
/// are the caller's mistake and not checked.
template <class Scalar>
class DenseMatrix {
 public:
  using Index = std::ptrdiff_t;

  DenseMatrix() = default;
  DenseMatrix(Index rows, Index columns)  ///< zeros
      : rows_(rows), columns_(columns), entries_(static_cast<std::size_t>(rows * columns)) {}
  explicit DenseMatrix(Index size) : DenseMatrix(size, 1) {}
  static DenseMatrix identity(Index size);

  [[nodiscard]] Index rows() const { return rows_; }
  [[nodiscard]] Index columns() const { return columns_; }
  [[nodiscard]] Index size() const { return rows_ * columns_; }
  Scalar& operator()(Index row, Index column) { return entries_[at(row, column)]; }
  const Scalar& operator()(Index row, Index column) const { return entries_[at(row, column)]; }
  Scalar& operator()(Index row) { return entries_[static_cast<std::size_t>(row)]; }
  const Scalar& operator()(Index row) const { return entries_[static_cast<std::size_t>(row)]; }

  [[nodiscard]] DenseMatrix block(Index row, Index column, Index rows, Index columns) const;
  void set_block(Index row, Index column, const DenseMatrix& block);
  [[nodiscard]] DenseMatrix column(Index column) const { return block(0, column, rows_, 1); }
  [[nodiscard]] DenseMatrix transpose() const;
  [[nodiscard]] DenseMatrix inverse() const;

  DenseMatrix operator-() const;
  DenseMatrix operator+(const DenseMatrix& y) const;
  DenseMatrix operator-(const DenseMatrix& y) const;
  DenseMatrix operator*(const DenseMatrix& y) const;
  DenseMatrix operator*(const Scalar& factor) const;
  DenseMatrix operator/(const Scalar& divisor) const;
  friend DenseMatrix operator*(const Scalar& factor, const DenseMatrix& x) { return x * factor; }

 private:
  [[nodiscard]] std::size_t at(Index row, Index column) const {
    return static_cast<std::size_t>(column * rows_ + row);
  }

  Index rows_ = 0, columns_ = 0;
  std::vector<Scalar> entries_;
};

using Matrix = DenseMatrix<Float>;
using Vector = Matrix;

template <class Scalar>
Scalar dot(const DenseMatrix<Scalar>& x, const DenseMatrix<Scalar>& y);
/// The sum of the squares of the entries, and its root.
template <class Scalar>
Scalar squared_norm(const DenseMatrix<Scalar>& x);
Float norm(const Matrix& x);
/// The largest size of an entry, or NaN if an entry is NaN: what is no number must not pass for a small one.
Float largest_entry(const Matrix& x);
DenseMatrix<double> in_double(const Matrix& x);

/// By elimination with partial pivoting; a column for each right-hand side.
template <class Scalar>
DenseMatrix<Scalar> solve(DenseMatrix<Scalar> matrix, DenseMatrix<Scalar> right);

/// Cholesky's factor of a positive definite matrix in place of its lower triangle; and with it the solution in
/// place of the right-hand side.
void factor_positive(DenseMatrix<double>& matrix);
void solve_factored(const DenseMatrix<double>& factor, DenseMatrix<double>& right);

/// Of a symmetric matrix: eigenvalues ascend, unit vectors are the columns.
template <class Scalar>
struct SymmetricEigen {
  DenseMatrix<Scalar> values;
  DenseMatrix<Scalar> vectors;
};
/// By Jacobi's rotations, to rounding: for matrices of a few rows.
template <class Scalar>
SymmetricEigen<Scalar> symmetric_eigen(DenseMatrix<Scalar> matrix);

}  // namespace nipref::ref
