#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <nipref/ref/number/internal/refined_solution.hpp>

namespace nipref::ref {
namespace {

constexpr int most_corrections = 100;
constexpr double least_contraction = 1e-3;

Float largest_entry(const Vector& x) {
  Float largest = 0;
  for (Vector::Index i = 0; i < x.size(); ++i) largest = std::max(largest, abs(x(i)));
  return largest;
}

/// right - matrix solution, without a number for each product.
Vector left_over(const Matrix& matrix, const Vector& solution, Vector right) {
  Float product;
  for (Matrix::Index k = 0; k < matrix.columns(); ++k) {
    for (Matrix::Index i = 0; i < matrix.rows(); ++i) {
      mpfr_mul(product.get(), matrix(i, k).get(), solution(k).get(), MPFR_RNDN);
      mpfr_sub(right(i).get(), right(i).get(), product.get(), MPFR_RNDN);
    }
  }
  return right;
}

class EliminatedInDouble {
 public:
  explicit EliminatedInDouble(const Matrix& matrix) : elimination_(in_double(matrix)) {}

  /// Nothing where a pivot is 0 in double.
  [[nodiscard]] std::optional<Vector> solution(const Vector& right, const Float& unit) const {
    Eigen::VectorXd here(right.size());
    for (Vector::Index i = 0; i < right.size(); ++i) here(i) = static_cast<double>(right(i) / unit);
    here = elimination_.solve(here);
    if (!here.allFinite()) return {};
    Vector result(right.size());
    for (Vector::Index i = 0; i < right.size(); ++i) result(i) = unit * here(i);
    return result;
  }

 private:
  static Eigen::MatrixXd in_double(const Matrix& matrix) {
    Eigen::MatrixXd result(matrix.rows(), matrix.columns());
    for (Matrix::Index k = 0; k < matrix.columns(); ++k) {
      for (Matrix::Index i = 0; i < matrix.rows(); ++i) result(i, k) = static_cast<double>(matrix(i, k));
    }
    return result;
  }

  Eigen::PartialPivLU<Eigen::MatrixXd> elimination_;
};

std::optional<Vector> by_corrections(const Matrix& matrix, const Vector& right) {
  const EliminatedInDouble in_double(matrix);
  Vector solution(right.size()), rest = right;
  Float before = 0;
  for (int step = 0; step < most_corrections; ++step) {
    const Float unit = largest_entry(rest);
    if (unit == 0) return solution;
    const std::optional<Vector> correction = in_double.solution(rest, unit);
    if (!correction) return {};
    const Float change = largest_entry(*correction);
    if (step > 0 && !(change < least_contraction * before)) {
      // So well conditioned a matrix loses no more than this to rounding.
      const bool is_rounding =
          change <= largest_entry(solution) * ldexp(std::numeric_limits<Float>::epsilon(), 43);
      return is_rounding ? std::optional(std::move(solution)) : std::nullopt;
    }
    solution = solution + *correction;
    rest = left_over(matrix, solution, right);
    before = change;
  }
  return {};
}

}  // namespace

Vector refined_solution(const Matrix& matrix, const Vector& right) {
  if (std::optional<Vector> solution = by_corrections(matrix, right)) return *std::move(solution);
  return solve(matrix, right);
}

}  // namespace nipref::ref
