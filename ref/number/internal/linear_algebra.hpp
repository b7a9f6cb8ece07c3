#pragma once
#include <cstddef>
#include <vector>

#include <nipref/ref/number/internal/float.hpp>

namespace nipref::ref {

/// A dense matrix of Float, by columns; a vector is one of a single column. The arithmetic is Eigen's, which
/// is compiled in linear_algebra.cpp alone. Shapes that do not fit are the caller's mistake and not checked.
class Matrix {
 public:
  using Index = std::ptrdiff_t;

  Matrix() = default;
  Matrix(Index rows, Index columns);  ///< zeros
  explicit Matrix(Index size) : Matrix(size, 1) {}
  static Matrix identity(Index size);

  [[nodiscard]] Index rows() const { return rows_; }
  [[nodiscard]] Index columns() const { return columns_; }
  [[nodiscard]] Index size() const { return rows_ * columns_; }
  Float& operator()(Index row, Index column) { return entries_[at(row, column)]; }
  const Float& operator()(Index row, Index column) const { return entries_[at(row, column)]; }
  Float& operator()(Index row) { return entries_[static_cast<std::size_t>(row)]; }
  const Float& operator()(Index row) const { return entries_[static_cast<std::size_t>(row)]; }
  [[nodiscard]] Float* data() { return entries_.data(); }
  [[nodiscard]] const Float* data() const { return entries_.data(); }

  [[nodiscard]] Matrix block(Index row, Index column, Index rows, Index columns) const;
  void set_block(Index row, Index column, const Matrix& block);
  [[nodiscard]] Matrix column(Index column) const { return block(0, column, rows_, 1); }
  [[nodiscard]] Matrix transpose() const;
  [[nodiscard]] Matrix inverse() const;

 private:
  [[nodiscard]] std::size_t at(Index row, Index column) const {
    return static_cast<std::size_t>(column * rows_ + row);
  }

  Index rows_ = 0, columns_ = 0;
  std::vector<Float> entries_;
};

using Vector = Matrix;

Matrix operator-(const Matrix& x);
Matrix operator+(const Matrix& x, const Matrix& y);
Matrix operator-(const Matrix& x, const Matrix& y);
Matrix operator*(const Matrix& x, const Matrix& y);
Matrix operator*(const Float& x, const Matrix& y);
Matrix operator/(const Matrix& x, const Float& y);

Float dot(const Vector& x, const Vector& y);
/// The sum of the squares of the entries, and its root.
Float squared_norm(const Matrix& x);
Float norm(const Matrix& x);

/// By elimination with partial pivoting.
Vector solve(const Matrix& matrix, const Vector& right);

/// Of a symmetric matrix: eigenvalues ascend, unit vectors are the columns.
struct SymmetricEigen {
  Vector values;
  Matrix vectors;
};
SymmetricEigen symmetric_eigen(const Matrix& matrix);

}  // namespace nipref::ref
