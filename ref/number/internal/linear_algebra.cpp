#include <algorithm>
#include <limits>
#include <utility>

#include <nipref/ref/number/internal/linear_algebra.hpp>

namespace nipref::ref {
namespace {

using Index = Eigen::Index;

/// Each correction of a solution gains some ten digits.
constexpr int most_corrections = 60;

using ref::add_product;
void add_product(double& sum, double& /*scratch*/, double x, double y) { sum += x * y; }

template <class Scalar>
void add_multiple_of_row(DenseMatrix<Scalar>& x, Index row, const Scalar& factor, Index other,
                         Index first_column) {
  Scalar product = 0;
  for (Index column = first_column; column < x.cols(); ++column)
    add_product(x(row, column), product, factor, x(other, column));
}

}  // namespace

template <class Scalar>
DenseMatrix<Scalar> DenseMatrix<Scalar>::operator*(const DenseMatrix& y) const {
  DenseMatrix result(this->rows(), y.cols());
  Scalar product = 0;
  for (Index k = 0; k < y.cols(); ++k) {
    for (Index j = 0; j < y.rows(); ++j) {
      for (Index i = 0; i < this->rows(); ++i) add_product(result(i, k), product, (*this)(i, j), y(j, k));
    }
  }
  return result;
}

template <class Scalar>
DenseMatrix<Scalar> DenseMatrix<Scalar>::inverse() const {
  DenseMatrix unit(this->rows(), this->rows());
  unit.diagonal().setOnes();
  return solve(*this, std::move(unit));
}

template <class Scalar>
DenseMatrix<Scalar> solve(DenseMatrix<Scalar> matrix, DenseMatrix<Scalar> right) {
  const Index size = matrix.rows();
  for (Index k = 0; k < size; ++k) {
    Index below = 0;
    matrix.col(k).tail(size - k).cwiseAbs().maxCoeff(&below);
    matrix.row(k).swap(matrix.row(k + below));
    right.row(k).swap(right.row(k + below));
    for (Index row = k + 1; row < size; ++row) {
      const Scalar factor = -matrix(row, k) / matrix(k, k);
      add_multiple_of_row(matrix, row, factor, k, k + 1);
      add_multiple_of_row(right, row, factor, k, 0);
    }
  }
  for (Index k = size - 1; k >= 0; --k) {
    right.row(k) /= matrix(k, k);
    for (Index row = 0; row < k; ++row) add_multiple_of_row<Scalar>(right, row, -matrix(row, k), k, 0);
  }
  return right;
}

template class DenseMatrix<Float>;
template Matrix solve(Matrix matrix, Matrix right);

template class DenseMatrix<double>;
template DenseMatrix<double> solve(DenseMatrix<double> matrix, DenseMatrix<double> right);

Float largest_entry(const Matrix& x) {
  Float largest = 0;
  for (Index i = 0; i < x.size(); ++i) {
    const Float size = abs(x(i));
    if (!(size == size)) return size;
    largest = std::max(largest, size);
  }
  return largest;
}

std::optional<Vector> refined_solution(const EliminatedInDouble& approximate, const Vector& right,
                                       const std::function<Vector(const Vector&)>& apply) {
  const Vector::Index size = right.size();
  Vector x(size), rest = right;
  const Float enough = size * std::numeric_limits<Float>::epsilon() * largest_entry(right);
  for (int round = 0; round < most_corrections && largest_entry(rest) > enough; ++round) {
    const Float scale = largest_entry(rest);
    Eigen::VectorXd correction(size);
    for (Vector::Index i = 0; i < size; ++i) correction(i) = static_cast<double>(rest(i) / scale);
    correction = approximate.solve(correction);
    if (!correction.allFinite()) return {};
    Vector better = x;
    for (Vector::Index i = 0; i < size; ++i) better(i) += correction(i) * scale;
    Vector left = right - apply(better);
    if (!(largest_entry(left) < scale)) break;
    x = std::move(better);
    rest = std::move(left);
  }
  return largest_entry(rest) <= 1000 * enough ? std::optional(std::move(x)) : std::nullopt;
}

Vector refined_solution(const Matrix& matrix, const Vector& right) {
  auto solution = refined_solution(EliminatedInDouble(matrix.cast<double>()), right,
                                   [&](const Vector& x) { return matrix * x; });
  return solution ? *std::move(solution) : solve(matrix, right);
}

}  // namespace nipref::ref
