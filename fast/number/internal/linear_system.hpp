#pragma once
#include <Eigen/Core>

namespace nipref::fast {

// Eigen's algorithms for matrices of any size, which are compiled only once, in linear_system.cpp, as each takes
// seconds to compile.

/// The solution by elimination with partial pivoting; `matrix` is square.
Eigen::VectorXd linear_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
/// The same with a column for each right-hand side.
Eigen::MatrixXd linear_solution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// The vector that makes the residual least; `matrix` has at least as many rows as columns.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Estimate of the condition number in the column-sum norm.
double condition_estimate(const Eigen::MatrixXd& matrix);

}  // namespace nipref::fast
