#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/internal/direction_words.hpp>
#include <nipref/fast/half_space/internal/isotropic_line.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/number/internal/bisection.hpp>
#include <nipref/fast/number/internal/checks.hpp>

namespace nipref::fast {
namespace {

using internal::IsotropicLine;
using internal::Two;

constexpr Two one{1};

bool is_subcritical(const IsotropicLine& line) { return line.shear_decay.high > 0 && line.rayleigh.high > 0; }

/// The line with this X. If X is not below 1, its value at the speed of shear waves, all other members are 0.
IsotropicLine line_at(Two X, double poisson) {
  const Two below_shear = one - X;
  if (!(below_shear.high > 0)) return {X, {}, {}, {}, {}, {}};
  const Two ratio = internal::inverse_squared_pressure_speed(poisson);
  const Two wS = sqrt(below_shear);
  const Two wD = sqrt(one - ratio * X);
  // (1 - wS wD)/X, rationalised
  const Two defect = (one + ratio * below_shear) / (one + wS * wD);
  return {X, wS, wD, defect, Two{4} - X - 4 * defect, twice(defect) - one};
}

bool is_slow(Two speed, double poisson) { return is_subcritical(line_at(square(speed), poisson)); }

[[noreturn]] void refuse_supercritical(const data::IsotropicSolid& solid, double speed,
                                       Direction from_motion) {
  const double psi = std::acos(std::min(std::fabs(from_motion.cosine), 1.)) * (180 / std::numbers::pi);
  const double limit = isotropic_rayleigh_speed(solid.poisson) * std::sqrt(solid.shear / solid.density);
  throw data::BadInput(
      "speed", speed,
      fmt::format("must be below {}, which is critical on lines {:.6g} degrees from the motion",
                  limit / std::fabs(from_motion.cosine), psi));
}

/// The line at any speed.
IsotropicLine any_line(const data::IsotropicSolid& solid, double speed, Direction from_motion) {
  solid.check();
  internal::check_not_negative("speed", speed);
  internal::check_direction("psi", from_motion);
  // X uses the unit vector along from_motion: otherwise the rounding of from_motion's length would cause an error of K
  // that grows towards the Rayleigh speed.
  const Two along = speed * internal::cosine_of(from_motion);
  const Two X = solid.density * square(along) / internal::squared_length(from_motion) / solid.shear;
  return line_at(X, solid.poisson);
}

IsotropicLine line_beyond(const data::IsotropicSolid& solid, double speed, Direction from_motion) {
  const IsotropicLine line = any_line(solid, speed, from_motion);
  if (!(line.shear_decay.high > 0 && line.rayleigh.high < 0))
    throw data::BadInput("speed", speed,
                         "must be, along the line, between those of Rayleigh and of shear waves");
  return line;
}

/// Numerator and denominator have two words, as their terms cancel; double suffices for their quotient.
double quotient(Two numerator, Two denominator, double modulus) {
  return numerator.high / denominator.high / modulus;
}

LineResponse response_of(const IsotropicLine& line, double modulus) {
  return {quotient(line.pressure_decay, line.rayleigh, modulus),
          quotient(line.coupling, line.rayleigh, modulus)};
}

}  // namespace

Two internal::inverse_squared_pressure_speed(double poisson) {
  return two_sum(1, -2 * poisson) / two_sum(2, -2 * poisson);
}

IsotropicLine internal::isotropic_line(const data::IsotropicSolid& solid, double speed,
                                       Direction from_motion) {
  const IsotropicLine line = any_line(solid, speed, from_motion);
  if (!is_subcritical(line)) refuse_supercritical(solid, speed, from_motion);
  return line;
}

LineResponse isotropic_response(const data::IsotropicSolid& solid, double speed, Direction from_motion) {
  return response_of(internal::isotropic_line(solid, speed, from_motion), solid.shear);
}

// With e^{-wS kz} = e^{-wD kz} + (wS - wD) f[wD, wS] and wD^2 - wS^2 = X (1 - cD^-2) nothing cancels at rest.
PressureWave isotropic_pressure_wave(const data::IsotropicSolid& solid, double speed, Direction from_motion) {
  const IsotropicLine line = internal::isotropic_line(solid, speed, from_motion);
  const LineResponse y = response_of(line, solid.shear);
  const double wS = line.shear_decay.high, wD = line.pressure_decay.high;
  const double share =
      2 * y.compliance * (one - internal::inverse_squared_pressure_speed(solid.poisson)).high / (wS + wD);
  PressureWave wave(y);
  wave.decays = {wD, wS, wS};
  wave.count = 2;
  wave.shares[1] = {std::complex(0.0, wS * share), 0, -share};
  return wave;
}

LineResponse isotropic_response_beyond(const data::IsotropicSolid& solid, double speed,
                                       Direction from_motion) {
  return response_of(line_beyond(solid, speed, from_motion), solid.shear);
}

double rolling_index_beyond(const data::IsotropicSolid& solid, double speed, Direction from_motion) {
  const IsotropicLine line = line_beyond(solid, speed, from_motion);
  // With g^2 = wS wD: (q + 1)/(q - 1) = (1 - g^2)/X ((2 + 2g - X)/(1 + g))^2/(-R/X)
  const double g = std::sqrt(line.shear_decay.high * line.pressure_decay.high);
  const double slant = (2 + 2 * g - line.X.high) / (1 + g);
  return std::log(line.defect.high * slant * slant / -line.rayleigh.high) / (2 * std::numbers::pi);
}

double isotropic_condition(const data::IsotropicSolid& solid, double speed, Direction from_motion) {
  const IsotropicLine line = internal::isotropic_line(solid, speed, from_motion);
  const double X = line.X.high;
  const double ratio = internal::inverse_squared_pressure_speed(solid.poisson).high;
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
  const IsotropicLine line = internal::isotropic_line(solid, speed, from_motion);
  return {quotient(line.shear_decay, line.rayleigh, solid.shear),
          quotient(one, line.shear_decay, solid.shear)};
}

double isotropic_rayleigh_speed(double poisson) {
  data::IsotropicSolid{1, poisson, 1}.check();
  return internal::last_that([&](double speed) { return is_slow({speed}, poisson); }, 0, 1);
}

Two internal::rayleigh_speed_in_two_words(double poisson) {
  return last_in_two_words([&](Two speed) { return is_slow(speed, poisson); },
                           isotropic_rayleigh_speed(poisson));
}

}  // namespace nipref::fast
