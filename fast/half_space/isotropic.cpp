#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/number/internal/bisection.hpp>
#include <nipref/fast/number/internal/two_words_algebra.hpp>

namespace nipref::fast {
namespace {

using internal::Two;

constexpr Two one{1};

/// Two words each: what cancels, and does so more and more towards the Rayleigh speed, keeps its digits.
struct LineFunctions {
  Two shear_decay;     ///< wS
  Two pressure_decay;  ///< wD
  Two rayleigh;        ///< R/X, finite at rest
  Two coupling;        ///< (2 - X - 2 wS wD)/X, finite at rest
};

/// cD^-2 = (1 - 2 nu)/(2 - 2 nu)
Two inverse_squared_pressure_speed(double poisson) {
  return internal::two_sum(1, -2 * poisson) / internal::two_sum(2, -2 * poisson);
}

/// below_shear: 1 - X > 0.
LineFunctions line_functions(Two X, Two below_shear, double poisson) {
  const Two ratio = inverse_squared_pressure_speed(poisson);
  const Two wS = sqrt(below_shear);
  const Two wD = sqrt(one - ratio * X);
  // (1 - wS wD)/X, rationalised
  const Two defect = (one + ratio * below_shear) / (one + wS * wD);
  return {wS, wD, Two{4} - X - 4 * defect, twice(defect) - one};
}

bool subcritical(double speed, double poisson) {
  const Two X = internal::two_product(speed, speed);
  const Two below_shear = one - X;
  return below_shear.high > 0 && line_functions(X, below_shear, poisson).rayleigh.high > 0;
}

[[noreturn]] void refuse_supercritical(const data::IsotropicSolid& solid, double speed,
                                       Direction from_motion) {
  const double psi = std::acos(std::fabs(from_motion.cosine)) * (180 / std::numbers::pi);
  throw data::BadInput(
      "speed", speed,
      fmt::format("must be below {:.6g}, which is critical on lines {:.6g} degrees from the motion",
                  isotropic_rayleigh_speed(solid.poisson) / std::fabs(from_motion.cosine), psi));
}

LineFunctions line_functions(const data::IsotropicSolid& solid, double speed, Direction from_motion) {
  solid.check();
  if (!(std::isfinite(speed) && speed >= 0)) throw data::BadInput("speed", speed, "must be finite and >= 0");
  const double length = std::hypot(from_motion.cosine, from_motion.sine);
  if (!(std::fabs(length - 1) < 1e-9)) throw data::BadInput("psi", length, "must be of unit length");
  // Of the unit vector that from_motion stands for: near the motion the rounding of its cosine would be a
  // noise in K that grows towards the Rayleigh speed.
  const Two cosine2 = internal::two_product(from_motion.cosine, from_motion.cosine);
  const Two sine2 = internal::two_product(from_motion.sine, from_motion.sine);
  const Two speed2 = internal::two_product(speed, speed);
  const Two shortening = one / (cosine2 + sine2);
  const Two X = speed2 * cosine2 * shortening;
  const Two below_shear = (sine2 + (one - speed2) * cosine2) * shortening;
  if (below_shear.high > 0) {
    const LineFunctions functions = line_functions(X, below_shear, solid.poisson);
    if (functions.rayleigh.high > 0) return functions;
  }
  refuse_supercritical(solid, speed, from_motion);
}

/// All that cancels has done so: the quotient itself is taken in double.
double quotient(Two numerator, Two denominator, double modulus) {
  return numerator.high / denominator.high / modulus;
}

}  // namespace

LineResponse isotropic_response(const data::IsotropicSolid& solid, double speed, Direction from_motion) {
  const LineFunctions line = line_functions(solid, speed, from_motion);
  return {quotient(line.pressure_decay, line.rayleigh, solid.shear),
          quotient(line.coupling, line.rayleigh, solid.shear)};
}

double isotropic_condition(const data::IsotropicSolid& solid, double speed, Direction from_motion) {
  const LineFunctions line = line_functions(solid, speed, from_motion);
  const double X = std::pow(speed * from_motion.cosine, 2);
  const double ratio = inverse_squared_pressure_speed(solid.poisson).high;
  const double wS = line.shear_decay.high, wD = line.pressure_decay.high, roots = wS * wD;
  // With K = wD/r, r = R/X = 4 - X - 4 (1 - roots)/X, derivatives with respect to X.
  const double roots_slope = -(wD / wS + ratio * wS / wD) / 2;
  const double defect_slope =
      -(ratio * (1 + roots) + (1 + ratio - X * ratio) * roots_slope) / ((1 + roots) * (1 + roots));
  const double r_slope = -1 - 4 * defect_slope;
  return 2 * X * (-ratio / (2 * wD * wD) - r_slope / line.rayleigh.high);
}

ShearResponse isotropic_shear_response(const data::IsotropicSolid& solid, double speed,
                                       Direction from_motion) {
  const LineFunctions line = line_functions(solid, speed, from_motion);
  return {quotient(line.shear_decay, line.rayleigh, solid.shear),
          quotient(one, line.shear_decay, solid.shear)};
}

double isotropic_rayleigh_speed(double poisson) {
  data::IsotropicSolid{1, poisson, 1}.check();
  return internal::last_that([&](double speed) { return subcritical(speed, poisson); }, 0, 1);
}

}  // namespace nipref::fast
