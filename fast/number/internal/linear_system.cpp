#include <Eigen/LU>
#include <limits>
#include <random>

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

SolutionAndTwins solution_and_twins(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& size,
                                    const Eigen::VectorXd& right) {
  constexpr Eigen::Index twins = 8;
  constexpr double unit = std::numeric_limits<double>::epsilon();
  const Eigen::PartialPivLU<Eigen::MatrixXd> elimination(matrix);
  const Eigen::VectorXd solution = elimination.solve(right);
  const Eigen::ArrayXd rounding =
      unit *
      ((size.array().square().matrix() * solution.array().square().matrix()).array() + right.array().square())
          .sqrt();
  std::mt19937_64 random;
  std::normal_distribution<double> normal;
  Eigen::MatrixXd change(right.size(), twins);
  for (Eigen::Index i = 0; i < change.size(); ++i) change(i) = normal(random);
  change.array().colwise() *= rounding;
  return {solution, elimination.solve(change).colwise() + solution};
}

double condition_estimate(const Eigen::MatrixXd& matrix) { return 1 / matrix.partialPivLu().rcond(); }

Eigen::MatrixXd product(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) { return x * y; }
Eigen::MatrixXcd product(const Eigen::MatrixXcd& x, const Eigen::MatrixXcd& y) { return x * y; }

Eigen::MatrixXd scaled_product(double factor, const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) {
  return factor * (x * y);
}

}  // namespace nipref::fast
