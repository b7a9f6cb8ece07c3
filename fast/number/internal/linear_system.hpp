#pragma once
#include <Eigen/Core>
#include <Eigen/LU>

namespace nipref::fast {

// Eigen's algorithms for matrices of any size, which are compiled only once, in linear_system.cpp, as each takes
// seconds to compile.

/// Solves systems of a square matrix by elimination with partial pivoting.
class Elimination {
 public:
  Elimination() = default;
  explicit Elimination(const Eigen::MatrixXd& matrix);

  [[nodiscard]] Eigen::Index size() const { return factors_.rows(); }
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  /// A column for each right-hand side.
  [[nodiscard]] Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& right) const;
  /// With the transposed matrix.
  [[nodiscard]] Eigen::VectorXd solve_transposed(Eigen::VectorXd right) const;
  /// Estimate of the condition number in the column-sum norm.
  [[nodiscard]] double condition() const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

/// The vector that makes the residual least; `matrix` has at least as many rows as columns.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

}  // namespace nipref::fast
