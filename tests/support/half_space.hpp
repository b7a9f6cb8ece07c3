#pragma once
#include <nipref/fast/half_space/response.hpp>

#include "support/test.hpp"

namespace nipref::test {

/// Poisson's ratio where it does not matter.
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

/// A point of an interval with its distances to both ends, which keep their digits.
struct IntervalPoint {
  double x, to_upper, to_lower;
};

/// (1/pi) vp int f(xi)/(xi - x) dxi over (lower, upper) for f that vanishes at the ends like a power: with xi
/// = middle + half tanh v the trapezoidal rule, its nodes half a step off the pole, converges geometrically.
inline double hilbert(double lower, double upper, double x, const std::function<double(IntervalPoint)>& f) {
  const double half = (upper - lower) / 2, middle = (upper + lower) / 2, step = 0.125;
  const double pole = std::atanh((x - middle) / half);
  double sum = 0;
  for (int node = -400; node < 400; ++node) {
    const double offset = (node + 0.5) * step, v = pole + offset;
    const double to_upper = 2 * half / (1 + std::exp(2 * v)), to_lower = 2 * half / (1 + std::exp(-2 * v));
    sum += f({middle + half * std::tanh(v), to_upper, to_lower}) * std::cosh(pole) /
           (std::cosh(v) * std::sinh(offset));
  }
  return sum * step / std::acos(-1.);
}

}  // namespace nipref::test
