#include <Eigen/LU>

#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {

Eigen::VectorXd linear_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.partialPivLu().solve(right);
}

Eigen::MatrixXd linear_solution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  return matrix.partialPivLu().solve(right);
}

Eigen::MatrixXcd linear_solution(const Eigen::MatrixXcd& matrix, const Eigen::MatrixXcd& right) {
  return matrix.partialPivLu().solve(right);
}

double condition_estimate(const Eigen::MatrixXd& matrix) { return 1 / matrix.partialPivLu().rcond(); }

Eigen::MatrixXd product(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) { return x * y; }
Eigen::MatrixXcd product(const Eigen::MatrixXcd& x, const Eigen::MatrixXcd& y) { return x * y; }

Eigen::MatrixXd scaled_product(double factor, const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) {
  return factor * (x * y);
}

}  // namespace nipref::fast
