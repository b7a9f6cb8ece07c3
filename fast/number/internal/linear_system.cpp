#include <Eigen/LU>
#include <utility>

#include <nipref/fast/number/internal/dense.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {

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

Eigen::VectorXd least_squares(Eigen::MatrixXd matrix, Eigen::VectorXd right) {
  internal::dense_code().least_squares(matrix.data(), right.data(), matrix.rows(), matrix.cols());
  return right.head(matrix.cols());
}

}  // namespace nipref::fast
