#include <cmath>

#include <nipref/fast/half_space/anisotropic.hpp>
#include <nipref/fast/half_space/internal/critical_speed.hpp>
#include <nipref/fast/number/internal/checks.hpp>

namespace nipref::fast {
namespace {

internal::AnisotropicLine checked_line(const data::Stiffness& solid) {
  solid.check();
  internal::check_moduli(solid);
  return internal::AnisotropicLine(solid);
}

}  // namespace

struct AnisotropicHalfSpace::Implementation {
  internal::AnisotropicLine line;
  internal::Motion motion;
  double speed;

  [[nodiscard]] internal::AnisotropicAnswers at(Direction psi) const {
    internal::check_direction("psi", psi);
    if (const auto answers = line.at(psi, motion)) return *answers;
    throw internal::supercritical(
        speed, {internal::speed_of_motion(line, motion.direction, psi), std::atan2(psi.sine, psi.cosine)});
  }
};

AnisotropicHalfSpace::AnisotropicHalfSpace(const data::Stiffness& solid, Direction motion, double speed)
    : implementation_(std::make_shared<const Implementation>(
          Implementation{checked_line(solid), {motion, internal::Two{speed}}, speed})) {
  internal::check_not_negative("speed", speed);
  internal::check_direction("motion", motion);
}

LineResponse AnisotropicHalfSpace::along(Direction psi) const { return implementation_->at(psi).normal; }

PressureWave AnisotropicHalfSpace::inside(Direction psi) const {
  const LineResponse surface = along(psi);  // throws unless the line is subcritical
  return {surface, *implementation_->line.decay(psi, implementation_->motion)};
}

ShearResponse AnisotropicHalfSpace::shear_along(Direction psi) const {
  return implementation_->at(psi).shear;
}

double rayleigh_speed(const data::Stiffness& solid, Direction motion, Direction psi) {
  internal::check_direction("motion", motion);
  internal::check_direction("psi", psi);
  return internal::speed_of_motion(checked_line(solid), motion, psi);
}

CriticalSpeed critical_speed(const data::Stiffness& solid, Direction motion) {
  internal::check_direction("motion", motion);
  constexpr std::size_t most_lines = 800;  // up to ten milliseconds each
  const internal::AnisotropicLine line = checked_line(solid);
  return internal::critical_speed(line, line, motion, most_lines);
}

}  // namespace nipref::fast
