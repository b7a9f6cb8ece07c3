#include <Eigen/LU>
#include <Eigen/QR>

#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {

Eigen::VectorXd linear_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.partialPivLu().solve(right);
}

Eigen::MatrixXd linear_solution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  return matrix.partialPivLu().solve(right);
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.householderQr().solve(right);
}

double condition_estimate(const Eigen::MatrixXd& matrix) { return 1 / matrix.partialPivLu().rcond(); }

}  // namespace nipref::fast
