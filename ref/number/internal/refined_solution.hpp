#pragma once
#include <Eigen/LU>
#include <functional>
#include <optional>

#include <nipref/ref/number/internal/linear_algebra.hpp>

namespace nipref::ref {

using EliminatedInDouble = Eigen::PartialPivLU<Eigen::MatrixXd>;

/// The solution x of apply(x) = right by iterative refinement. `approximate`, nearly the same system in double, gives
/// corrections from the residuals in the working precision, until a residual is of the order of the rounding errors. Nothing
/// if none becomes so small.
std::optional<Vector> refined_solution(const EliminatedInDouble& approximate, const Vector& right,
                                       const std::function<Vector(const Vector&)>& apply);

/// The result of solve(), up to rounding, for one right-hand side. Computed by iterative refinement, which takes a
/// fraction of the time, unless the matrix is so close to singular that refinement does not converge; then by solve().
Vector refined_solution(const Matrix& matrix, const Vector& right);

}  // namespace nipref::ref
