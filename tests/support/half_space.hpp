#pragma once
#include <nipref/fast/half_space/response.hpp>

#include "support/test.hpp"

namespace nipref::test {

/// Poisson's ratio of tests in which it does not matter.
inline constexpr double any_poisson = 1. / 3;

/// An isotropic solid of shear modulus 1 under a load that moves along x1 at `speed` shear wave speeds.
/// (brock2012 18a)
inline fast::LineResponse isotropic_line(double poisson, double speed, fast::Direction psi) {
  const double k = (1 - 2 * poisson) / (2 - 2 * poisson), x = std::pow(speed * psi.cosine, 2);
  const double dilatation = std::sqrt(1 - k * x);
  const double product = std::sqrt(1 - x) * dilatation;
  const double defect = (1 + k - k * x) / (1 + product);  // (1 - wS wD)/X, no 0/0 at X = 0
  const double rayleigh = 4 - x - 4 * defect;
  return {dilatation / rayleigh, (2 * defect - 1) / rayleigh};
}

inline fast::SurfaceResponse isotropic(double poisson, double speed) {
  return [=](fast::Direction psi) { return isotropic_line(poisson, speed, psi); };
}

}  // namespace nipref::test
