#include <Eigen/LU>
#include <utility>

#include <nipref/fast/number/internal/dense.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {

const internal::DenseCode& internal::dense_code() {
#ifdef NIPREF_X86_LEVELS
  if (chosen_instruction_set > 0) return v3::dense_code;
#endif
  return baseline::dense_code;
}

namespace {

Eigen::MatrixXd product_of(const Eigen::MatrixXd& left, const auto& right) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(left.rows(), right.cols());
  add_product(left, right, sum);
  return sum;
}

}  // namespace

Elimination::Elimination(Eigen::MatrixXd matrix) : triangles_(std::move(matrix)), order_(size()) {
  internal::dense_code().factor(triangles_.data(), order_.data(), size());
}

Eigen::VectorXd Elimination::solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd solution(size());
  solution(order_) = right;
  triangles_.triangularView<Eigen::UnitLower>().solveInPlace(solution);
  triangles_.triangularView<Eigen::Upper>().solveInPlace(solution);
  return solution;
}

Eigen::MatrixXd Elimination::solve_columns(const Eigen::MatrixXd& right) const {
  Eigen::MatrixXd solutions(right.rows(), right.cols());
  for (Eigen::Index k = 0; k < right.cols(); ++k) solutions.col(k) = solve(right.col(k));
  return solutions;
}

Eigen::VectorXd Elimination::solve_transposed(Eigen::VectorXd right) const {
  const auto triangles = triangles_.transpose();
  triangles.triangularView<Eigen::Lower>().solveInPlace(right);
  triangles.triangularView<Eigen::UnitUpper>().solveInPlace(right);
  return right(order_);
}

double condition_number(const Eigen::MatrixXd& matrix) {
  return 1 / Eigen::PartialPivLU<Eigen::MatrixXd>(matrix).rcond();
}

void add_product(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right, Eigen::Ref<Eigen::MatrixXd> sum) {
  internal::dense_code().add_product(left.data(), right.data(), sum.data(), sum.rows(), right.rows(),
                                     sum.cols(), sum.outerStride());
}

void add_product(const Eigen::MatrixXd& left, const Eigen::SparseMatrix<double>& right,
                 Eigen::Ref<Eigen::MatrixXd> sum) {
  for (Eigen::Index column = 0; column < right.cols(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(right, column); entry; ++entry)
      sum.col(column) += entry.value() * left.col(entry.row());
}

Eigen::MatrixXd product(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right) {
  return product_of(left, right);
}

Eigen::MatrixXd product(const Eigen::MatrixXd& left, const Eigen::SparseMatrix<double>& right) {
  return product_of(left, right);
}

/// The method of Peters and Wilkinson (1970). In P A = L U, L has more rows than columns and is well conditioned;
/// y = U x is the least-squares solution of L y = P b. The upper rows of L are the square matrix L1, the few others are
/// L2. With C = L2 L1^-1, y = L1^-1 (b1 + C^T (1 + C C^T)^-1 (b2 - C b1)), where b1 and b2 are the parts of P b.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  const Eigen::Index rows = matrix.rows(), columns = matrix.cols(), more = rows - columns;
  // Columns of zeros make the matrix square, as Eigen's elimination requires.
  Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(rows, rows);
  factors.leftCols(columns) = matrix;
  Eigen::VectorXi order(rows);
  internal::dense_code().factor(factors.data(), order.data(), rows);
  const auto square = factors.topLeftCorner(columns, columns);
  Eigen::MatrixXd transposed_c = factors.bottomLeftCorner(more, columns).transpose();
  for (auto column : transposed_c.colwise())
    square.transpose().triangularView<Eigen::UnitUpper>().solveInPlace(column);
  Eigen::VectorXd permuted(rows);
  permuted(order) = right;
  Eigen::VectorXd solution = permuted.head(columns);
  const Eigen::VectorXd residuals = permuted.tail(more) - transposed_c.transpose() * solution;
  const Eigen::MatrixXd of_residuals =
      Eigen::MatrixXd::Identity(more, more) + product(transposed_c.transpose(), transposed_c);
  solution += transposed_c * Elimination(of_residuals).solve(residuals);
  square.triangularView<Eigen::UnitLower>().solveInPlace(solution);
  square.triangularView<Eigen::Upper>().solveInPlace(solution);
  return solution;
}

}  // namespace nipref::fast
