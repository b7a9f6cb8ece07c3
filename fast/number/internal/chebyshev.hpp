#pragma once
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace nipref::fast::internal {

/// Zero number i = 0 .. count - 1, in ascending order, of T_count(2 x - 1), without cancellation near 0.
inline double shifted_chebyshev_zero(int i, int count) {
  return std::pow(std::sin((2 * i + 1) * std::numbers::pi / (4 * count)), 2);
}

/// The logarithm of rho, the sum of the half axes of the ellipse through z with foci -1 and 1. If z is the nearest
/// singularity of a function, its Chebyshev coefficients fall like rho^-n.
inline double log_of_ellipse(std::complex<double> z) {
  const double axis = (std::abs(z - 1.0) + std::abs(z + 1.0)) / 2;
  return std::acosh(std::max(axis, 1.0));
}

/// The number of Chebyshev points on [0, width] that give a function to e^-nats, if it is analytic for |Im alpha| < 2 and
/// grows like e^(rate |alpha|) at most. On the ellipse through 2 i, |alpha| <= reach; its half axes sum to e^fall width/2.
inline double points_of_analytic(double width, double rate, double nats) {
  const double fall = log_of_ellipse({-1, 4 / width}), reach = width / 2 * (1 + std::cosh(fall));
  return 1 + (nats + rate * reach) / fall;
}

}  // namespace nipref::fast::internal
