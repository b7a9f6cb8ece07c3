#pragma once
#include <Eigen/Core>

namespace nipref::fast {

// Eigen's algorithms for matrices of any size, which are compiled only once, in linear_system.cpp, as each takes
// seconds to compile.

/// The solution by elimination with partial pivoting; `matrix` is square.
Eigen::VectorXd linear_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
/// The same with a column for each right-hand side.
Eigen::MatrixXd linear_solution(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);
Eigen::MatrixXcd linear_solution(const Eigen::MatrixXcd& matrix, const Eigen::MatrixXcd& right);

/// A solution, and in the columns of `twins` solutions that other roundings could have given: to first order those of
/// systems whose row sums are each changed by 2^-52 times the root of the sum of their summands' squares, times a
/// normally distributed number. `size` has the size of the terms from which each entry of the matrix is computed,
/// larger than the entry where they cancel. The random numbers are the same in each run.
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
