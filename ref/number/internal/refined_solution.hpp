#pragma once
#include <nipref/ref/number/internal/linear_algebra.hpp>

namespace nipref::ref {

/// The same as solve(), to within rounding in the working precision, for one right-hand side and in a fraction of the time
/// where the matrix is far from singular: eliminated in double, corrected by what the solution leaves in the working
/// precision until that no longer changes it. Where corrections do not shrink a thousandfold each, by solve().
Vector refined_solution(const Matrix& matrix, const Vector& right);

}  // namespace nipref::ref
