#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace nipref::fast {

// Eigen's algorithms for matrices of any size, which only linear_system.cpp and arithmetic/dense.cpp compile, as each takes
// seconds to compile.

/// Solves systems of a square matrix by elimination with partial pivoting.
class Elimination {
 public:
  Elimination() = default;
  explicit Elimination(Eigen::MatrixXd matrix);

  [[nodiscard]] Eigen::Index size() const { return triangles_.rows(); }
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  /// A column for each right-hand side.
  [[nodiscard]] Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& right) const;
  /// With the transposed matrix.
  [[nodiscard]] Eigen::VectorXd solve_transposed(Eigen::VectorXd right) const;

 private:
  Eigen::MatrixXd triangles_;  ///< of P A = L U
  Eigen::VectorXi order_;      ///< where P puts the rows of A
};

/// Estimate of the condition number in the column-sum norm.
double condition_number(const Eigen::MatrixXd& matrix);

/// sum += left right
void add_product(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right, Eigen::Ref<Eigen::MatrixXd> sum);
/// By columns; Eigen's own takes the rows of `left`, whose numbers lie apart.
void add_product(const Eigen::MatrixXd& left, const Eigen::SparseMatrix<double>& right,
                 Eigen::Ref<Eigen::MatrixXd> sum);
Eigen::MatrixXd product(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right);
Eigen::MatrixXd product(const Eigen::MatrixXd& left, const Eigen::SparseMatrix<double>& right);

/// The vector that makes the residual least; `matrix` has more rows than columns.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

}  // namespace nipref::fast
