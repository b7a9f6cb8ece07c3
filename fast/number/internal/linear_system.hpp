#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace nipref::fast {

// Eigen's algorithms for matrices of any size. Only linear_system.cpp and arithmetic/dense.cpp compile them, as each
// takes seconds to compile.

/// Solves systems of a square matrix by elimination with partial pivoting.
class Elimination {
 public:
  Elimination() = default;
  explicit Elimination(Eigen::MatrixXd matrix);

  [[nodiscard]] Eigen::Index size() const { return triangles_.rows(); }
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  /// Solves for several right-hand sides, which are the columns of `right`.
  [[nodiscard]] Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& right) const;
  /// Solves the system of the transposed matrix.
  [[nodiscard]] Eigen::VectorXd solve_transposed(Eigen::VectorXd right) const;

 private:
  Eigen::MatrixXd triangles_;  ///< L and U of P A = L U
  Eigen::VectorXi order_;      ///< row i of A is row order_[i] of P A
};

/// Returns an estimate of the condition number in the column-sum norm.
double condition_number(const Eigen::MatrixXd& matrix);

/// sum += left right
void add_product(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right, Eigen::Ref<Eigen::MatrixXd> sum);
/// sum += left right, by columns of `left`. Eigen's own product reads rows of `left`, which are not contiguous.
void add_product(const Eigen::MatrixXd& left, const Eigen::SparseMatrix<double>& right,
                 Eigen::Ref<Eigen::MatrixXd> sum);
Eigen::MatrixXd product(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right);
Eigen::MatrixXd product(const Eigen::MatrixXd& left, const Eigen::SparseMatrix<double>& right);

/// The vector that minimises the Euclidean norm of the residual; `matrix` has more rows than columns.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

}  // namespace nipref::fast
