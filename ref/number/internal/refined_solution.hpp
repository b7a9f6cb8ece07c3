#pragma once
#include <functional>
#include <optional>

#include <nipref/ref/number/internal/linear_algebra.hpp>

namespace nipref::ref {

/// x with `apply(x)` = right, `apply` a product with the matrix that `matrix` is nearly: eliminated in double, corrected by
/// what x leaves in the working precision until that is rounding. Nothing where it does not become so.
std::optional<Vector> refined_solution(const DenseMatrix<double>& matrix, const Vector& right,
                                       const std::function<Vector(const Vector&)>& apply);

/// The same as solve() for one right-hand side, up to rounding, in a fraction of the time where the matrix is far from
/// singular; where it is not, by solve().
Vector refined_solution(const Matrix& matrix, const Vector& right);

}  // namespace nipref::ref
