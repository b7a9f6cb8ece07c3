#pragma once
#include <Eigen/Core>

namespace nipref::fast::internal {

/// The Chebyshev points of [0, length], the zeros of T_count(2 x/length - 1), in ascending order.
Eigen::ArrayXd chebyshev_points(double length, Eigen::Index count);
/// The matrix that maps a polynomial's values at the `count` Chebyshev points of [0, length] to its values at `places`.
Eigen::MatrixXd interpolation(const Eigen::ArrayXd& places, double length, Eigen::Index count);

}  // namespace nipref::fast::internal
