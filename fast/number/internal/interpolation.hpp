#pragma once
#include <Eigen/Core>

namespace nipref::fast::internal {

/// The Chebyshev points of [0, length], the zeros of T_count(2 x/length - 1), rising.
Eigen::ArrayXd chebyshev_points(double length, Eigen::Index count);
/// The matrix that makes a polynomial's values at places of those at these points.
Eigen::MatrixXd interpolation(const Eigen::ArrayXd& places, double length, Eigen::Index count);

}  // namespace nipref::fast::internal
