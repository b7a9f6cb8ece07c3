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

namespace {

/// The larger number, or NaN if one of them is NaN, so that NaN does not pass for a small error.
Float larger(const Float& a, const Float& b) { return a >= b || !(a == a) ? a : b; }

Float row_sum_norm(const Matrix& matrix) {
  Float largest = 0;
  for (Matrix::Index i = 0; i < matrix.rows(); ++i) {
    Float sum = 0;
    for (Matrix::Index j = 0; j < matrix.cols(); ++j) sum += abs(matrix(i, j));
    largest = larger(largest, sum);
  }
  return largest;
}

void keep(Float& entry, Float& error, const Interval& value) {
  entry = middle_of(value);
  error = larger(error, upper_end(distance_from(entry, value)));
}

}  // namespace

void NearlyKnownSystem::set(Matrix::Index row, Matrix::Index column, const Interval& value) {
  keep(matrix(row, column), error, value);
}
void NearlyKnownSystem::set_right(Matrix::Index row, Matrix::Index column, const Interval& value) {
  keep(right(row, column), right_error(column), value);
}

// The rounding error of a sum of n products is at most (n + 2) epsilon times the sum of their magnitudes; with 4 right
// it includes that of the subtraction. The bounds are themselves sums of some n positive numbers, rounded by less than
// 1e-3.
std::optional<EnclosedSolutions> enclosed_solutions(const NearlyKnownSystem& system) {
  const auto n = system.matrix.rows();
  const Matrix inverse = system.matrix.inverse();
  const Float unit = (n + 2) * std::numeric_limits<Float>::epsilon();
  const Float size = row_sum_norm(system.matrix) + n * system.error;
  const Float inverse_size = row_sum_norm(inverse);
  const Float defect = row_sum_norm(Matrix::Identity(n, n) - inverse * system.matrix) +
                       unit * inverse_size * size + inverse_size * n * system.error;
  if (!(defect < 0.5)) return std::nullopt;
  EnclosedSolutions result{{}, 0, 0, size * inverse_size};
  for (Matrix::Index column = 0; column < system.right.cols(); ++column) {
    const Vector right = system.right.col(column), unknowns = inverse * right;
    const Vector residual = right - system.matrix * unknowns;
    const Float of_residual = unit * (size * largest_entry(unknowns) + 4 * largest_entry(right)) +
                              n * system.error * largest_entry(unknowns) +
                              (system.right_error.size() > 0 ? system.right_error(column) : Float(0));
    const Float error =
        inverse_size * (largest_entry(residual) + of_residual) / (1 - defect) * (1 + Float(1e-3));
    std::vector<Interval> enclosed;
    for (Matrix::Index i = 0; i < n; ++i)
      enclosed.push_back(interval_of(unknowns(i)).widened(interval_of(error)));
    result.unknowns.push_back(std::move(enclosed));
    result.error = larger(result.error, error);
    result.largest = larger(result.largest, largest_entry(unknowns));
  }
  return result;
}

}  // namespace nipref::ref
