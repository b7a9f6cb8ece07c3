#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>

#include <nipref/ref/number/internal/linear_algebra.hpp>

// What Eigen asks of a number.

namespace nipref::ref {

inline bool isinf(const Float& x) { return mpfr_inf_p(x.get()) != 0; }
inline bool isnan(const Float& x) { return mpfr_nan_p(x.get()) != 0; }
inline bool isfinite(const Float& x) { return mpfr_number_p(x.get()) != 0; }

}  // namespace nipref::ref

template <>
struct Eigen::NumTraits<nipref::ref::Float> {
  using Real = nipref::ref::Float;
  using NonInteger = Real;
  using Literal = double;
  using Nested = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 1,
    AddCost = 4,
    MulCost = 8
  };
  static Real epsilon() { return std::numeric_limits<Real>::epsilon(); }
  static Real infinity() { return HUGE_VAL; }
  static Real quiet_NaN() { return NAN; }
};

namespace nipref::ref {
namespace {

using Dense = Eigen::Matrix<Float, Eigen::Dynamic, Eigen::Dynamic>;
using DenseVector = Eigen::Matrix<Float, Eigen::Dynamic, 1>;

Eigen::Map<const Dense> dense(const Matrix& x) { return {x.data(), x.rows(), x.columns()}; }
Eigen::Map<const DenseVector> dense_vector(const Matrix& x) { return {x.data(), x.size()}; }
Eigen::Map<Dense> dense(Matrix& x) { return {x.data(), x.rows(), x.columns()}; }
Eigen::Map<DenseVector> dense_vector(Matrix& x) { return {x.data(), x.size()}; }

template <class Operation>
Matrix entrywise(const Matrix& x, const Matrix& y, Operation operation) {
  Matrix result(x.rows(), x.columns());
  std::transform(x.data(), x.data() + x.size(), y.data(), result.data(), operation);
  return result;
}

template <class Operation>
Matrix entrywise(const Matrix& x, Operation operation) {
  Matrix result(x.rows(), x.columns());
  std::transform(x.data(), x.data() + x.size(), result.data(), operation);
  return result;
}

}  // namespace

Matrix::Matrix(Index rows, Index columns)
    : rows_(rows), columns_(columns), entries_(static_cast<std::size_t>(rows * columns)) {}

Matrix Matrix::identity(Index size) {
  Matrix result(size, size);
  for (Index i = 0; i < size; ++i) result(i, i) = 1;
  return result;
}

Matrix Matrix::block(Index row, Index column, Index rows, Index columns) const {
  Matrix result(rows, columns);
  for (Index k = 0; k < columns; ++k) {
    for (Index i = 0; i < rows; ++i) result(i, k) = (*this)(row + i, column + k);
  }
  return result;
}

void Matrix::set_block(Index row, Index column, const Matrix& block) {
  for (Index k = 0; k < block.columns(); ++k) {
    for (Index i = 0; i < block.rows(); ++i) (*this)(row + i, column + k) = block(i, k);
  }
}

Matrix Matrix::transpose() const {
  Matrix result(columns_, rows_);
  for (Index k = 0; k < columns_; ++k) {
    for (Index i = 0; i < rows_; ++i) result(k, i) = (*this)(i, k);
  }
  return result;
}

Matrix Matrix::inverse() const {
  Matrix result(rows_, columns_);
  dense(result) = dense(*this).inverse();
  return result;
}

Matrix operator-(const Matrix& x) { return entrywise(x, std::negate<>()); }
Matrix operator+(const Matrix& x, const Matrix& y) { return entrywise(x, y, std::plus<>()); }
Matrix operator-(const Matrix& x, const Matrix& y) { return entrywise(x, y, std::minus<>()); }
Matrix operator*(const Float& x, const Matrix& y) {
  return entrywise(y, [&](const Float& entry) { return x * entry; });
}
Matrix operator/(const Matrix& x, const Float& y) {
  return entrywise(x, [&](const Float& entry) { return entry / y; });
}

Matrix operator*(const Matrix& x, const Matrix& y) {
  Matrix result(x.rows(), y.columns());
  if (y.columns() == 1) {
    dense_vector(result) = dense(x) * dense_vector(y);
  } else {
    dense(result) = dense(x) * dense(y);
  }
  return result;
}

Float dot(const Vector& x, const Vector& y) { return dense_vector(x).dot(dense_vector(y)); }
Float squared_norm(const Matrix& x) { return dense(x).squaredNorm(); }
Float norm(const Matrix& x) { return sqrt(squared_norm(x)); }

Vector solve(const Matrix& matrix, const Vector& right) {
  Vector result(right.size());
  dense_vector(result) = dense(matrix).partialPivLu().solve(dense_vector(right));
  return result;
}

SymmetricEigen symmetric_eigen(const Matrix& matrix) {
  const Eigen::SelfAdjointEigenSolver<Dense> solver(dense(matrix));
  SymmetricEigen result{Vector(matrix.rows()), Matrix(matrix.rows(), matrix.columns())};
  dense_vector(result.values) = solver.eigenvalues();
  dense(result.vectors) = solver.eigenvectors();
  return result;
}

}  // namespace nipref::ref
