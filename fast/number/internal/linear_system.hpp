#pragma once
#include <Eigen/Core>

namespace nipref::fast {

// Eigen's algorithms on matrices of any size, compiled once in linear_system.cpp: each costs a file that uses it
// seconds.

/// By elimination with partial pivoting; `matrix` square.
Eigen::VectorXd linear_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
/// A column for each right-hand side.
Eigen::MatrixXd linear_solution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);
Eigen::MatrixXcd linear_solution(const Eigen::MatrixXcd& matrix, const Eigen::MatrixXcd& right);

/// A solution, and in the columns of `twins` what rounding could as well have made it: solutions, to first order, of
/// systems in which each row's sum is changed by 2^-52 of the root of the sum of its summands' squares times a
/// normally distributed number. `size`: of what each entry of the matrix is computed from, its own or larger where
/// that cancels. The same each time.
struct SolutionAndTwins {
  Eigen::VectorXd solution;
  Eigen::MatrixXd twins;
};
SolutionAndTwins solution_and_twins(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& size,
                                    const Eigen::VectorXd& right);

/// Estimate of the condition number in the column-sum norm.
double condition_estimate(const Eigen::MatrixXd& matrix);

Eigen::MatrixXd product(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y);
Eigen::MatrixXcd product(const Eigen::MatrixXcd& x, const Eigen::MatrixXcd& y);
/// factor x y
Eigen::MatrixXd scaled_product(double factor, const Eigen::MatrixXd& x, const Eigen::MatrixXd& y);

}  // namespace nipref::fast
