#pragma once
#include <functional>
#include <optional>

#include <nipref/ref/number/internal/linear_algebra.hpp>

namespace nipref::ref {

using SolvedInDouble = std::function<Eigen::VectorXd(const Eigen::VectorXd& right)>;

/// The solution x of apply(x) = right by iterative refinement. `solved` solves nearly the same system in double: it gives
/// corrections from the residuals in the working precision, until a residual is of the order of the rounding errors. Nothing
/// if none becomes so small.
std::optional<Vector> refined_by(const SolvedInDouble& solved, const Vector& right,
                                 const std::function<Vector(const Vector&)>& apply);
/// The same where `apply` is the product with a matrix that `matrix` approximates.
std::optional<Vector> refined_solution(const DenseMatrix<double>& matrix, const Vector& right,
                                       const std::function<Vector(const Vector&)>& apply);

/// The result of solve(), up to rounding, for one right-hand side. Computed by iterative refinement, which takes a
/// fraction of the time, unless the matrix is so close to singular that refinement does not converge; then by solve().
Vector refined_solution(const Matrix& matrix, const Vector& right);

}  // namespace nipref::ref
