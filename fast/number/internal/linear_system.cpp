#include <Eigen/QR>

#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {

Elimination::Elimination(const Eigen::MatrixXd& matrix) : factors_(matrix) {}

Eigen::VectorXd Elimination::solve(const Eigen::VectorXd& right) const { return factors_.solve(right); }

Eigen::MatrixXd Elimination::solve_columns(const Eigen::MatrixXd& right) const {
  Eigen::MatrixXd solutions(right.rows(), right.cols());
  for (Eigen::Index k = 0; k < right.cols(); ++k) solutions.col(k) = solve(right.col(k));
  return solutions;
}

Eigen::VectorXd Elimination::solve_transposed(Eigen::VectorXd right) const {
  // By the triangles, since Eigen's transpose of an elimination holds a copy of it.
  const auto triangles = factors_.matrixLU().transpose();
  triangles.triangularView<Eigen::Lower>().solveInPlace(right);
  triangles.triangularView<Eigen::UnitUpper>().solveInPlace(right);
  return factors_.permutationP().transpose() * right;
}

double Elimination::condition() const { return 1 / factors_.rcond(); }

Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.householderQr().solve(right);
}

}  // namespace nipref::fast
