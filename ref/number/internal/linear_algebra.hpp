#pragma once
#include <Eigen/LU>
#include <boost/multiprecision/eigen.hpp>
#include <functional>
#include <optional>
#include <type_traits>
#include <vector>

#include <nipref/ref/number/float.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// Eigen's matrix of Float or double, initialised with zeros. A vector is a matrix of one column. Shapes are not
/// checked. Products and elimination of this class take half the time of Eigen's, because Eigen allocates a new number
/// for each product of two entries.
template <class Scalar>
class DenseMatrix : public Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> {
  using Base = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

 public:
  using Index = Eigen::Index;

  DenseMatrix() = default;
  DenseMatrix(Index rows, Index columns) : Base(rows, columns) {
    if constexpr (std::is_same_v<Scalar, double>) this->setZero();  // A new Float is 0.
  }
  explicit DenseMatrix(Index size) : DenseMatrix(size, 1) {}
  template <class Expression>
  DenseMatrix(const Eigen::MatrixBase<Expression>& x) : Base(x) {}
  template <class Expression>
  DenseMatrix& operator=(const Eigen::MatrixBase<Expression>& x) {
    Base::operator=(x);
    return *this;
  }

  using Base::operator*;
  DenseMatrix operator*(const DenseMatrix& y) const;
  [[nodiscard]] DenseMatrix inverse() const;
};

using Matrix = DenseMatrix<Float>;
using Vector = Matrix;

/// The largest magnitude of an entry, or NaN if an entry is NaN, so that NaN does not pass for a small number.
Float largest_entry(const Matrix& x);

/// The solutions for the right-hand sides, which are the columns of `right`, by elimination with partial pivoting.
template <class Scalar>
DenseMatrix<Scalar> solve(DenseMatrix<Scalar> matrix, DenseMatrix<Scalar> right);

using EliminatedInDouble = Eigen::PartialPivLU<Eigen::MatrixXd>;

/// The solution x of apply(x) = right by iterative refinement. The residuals have the working precision. `approximate`,
/// an LU decomposition of nearly the same matrix in double, gives the corrections. The iteration ends when the residual
/// is of the order of the rounding errors. Nothing if no residual becomes so small.
std::optional<Vector> refined_solution(const EliminatedInDouble& approximate, const Vector& right,
                                       const std::function<Vector(const Vector&)>& apply);

/// The result of solve(), up to rounding errors, for one right-hand side. Iterative refinement computes it in a
/// fraction of the time. If the matrix is so close to singular that refinement does not converge, solve() computes it.
Vector refined_solution(const Matrix& matrix, const Vector& right);

/// A linear system whose coefficients are known up to an error.
struct NearlyKnownSystem {
  Matrix matrix;
  Matrix right;             ///< a column for each right-hand side
  Float error = 0;          ///< error bound of each coefficient of the matrix
  Vector right_error = {};  ///< the same for each right-hand side, beyond rounding errors

  /// The system with all coefficients 0.
  static NearlyKnownSystem of_size(Matrix::Index unknowns, Matrix::Index right_sides) {
    return {Matrix(unknowns, unknowns), Matrix(unknowns, right_sides), 0, Vector(right_sides)};
  }
  /// Sets a coefficient to the middle of its enclosure, and raises the error bound where the enclosure is wider.
  void set(Matrix::Index row, Matrix::Index column, const Interval& value);
  void set_right(Matrix::Index row, Matrix::Index column, const Interval& value);
};

/// Enclosures of the solutions of all systems within the error bounds of a NearlyKnownSystem. None of them is singular.
struct EnclosedSolutions {
  std::vector<std::vector<Interval>> unknowns;  ///< a vector of the unknowns for each right-hand side
  Float error;                                  ///< the largest radius of an unknown
  Float largest;                                ///< the largest magnitude of an unknown's middle
  Float condition;                              ///< condition number of the matrix in the row-sum norm
};

/// Solves with an approximate inverse C: |x - truth| <= |C (b - A x)|/(1 - |1 - C A|). The bound includes the errors of
/// the coefficients and all rounding errors. Nothing if the working precision does not suffice for |1 - C A| < 1/2.
std::optional<EnclosedSolutions> enclosed_solutions(const NearlyKnownSystem& system);

}  // namespace nipref::ref
