#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/anisotropic.hpp>
#include <nipref/fast/half_space/internal/anisotropic_line.hpp>
#include <nipref/fast/half_space/internal/check_direction.hpp>
#include <nipref/fast/half_space/internal/check_moduli.hpp>
#include <nipref/fast/half_space/internal/critical_speed.hpp>

namespace nipref::fast {
namespace {

internal::AnisotropicLine checked_line(const data::Stiffness& solid) {
  solid.check();
  internal::check_moduli(solid);
  return internal::AnisotropicLine(solid);
}

double checked_speed(double speed) {
  if (!(std::isfinite(speed) && speed >= 0)) throw data::BadInput("speed", speed, "must be finite and >= 0");
  return speed;
}

}  // namespace

struct AnisotropicHalfSpace::Implementation {
  internal::AnisotropicLine line;
  internal::Motion motion;
  double speed;

  [[nodiscard]] internal::AnisotropicAnswers at(Direction psi) const {
    internal::check_direction("psi", psi);
    if (const auto answers = line.at(psi, motion)) return *answers;
    throw data::BadInput(
        "speed", speed,
        fmt::format("must be below {:.10g}, which is critical on the line psi = {:.6g} degrees",
                    internal::speed_of_motion(line, motion.direction, psi),
                    std::atan2(psi.sine, psi.cosine) * 180 / std::numbers::pi));
  }
};

AnisotropicHalfSpace::AnisotropicHalfSpace(const data::Stiffness& solid, Direction motion, double speed)
    : implementation_(std::make_unique<const Implementation>(
          Implementation{checked_line(solid), {motion, internal::Two{checked_speed(speed)}}, speed})) {
  internal::check_direction("motion", motion);
}

AnisotropicHalfSpace::AnisotropicHalfSpace(AnisotropicHalfSpace&&) noexcept = default;
AnisotropicHalfSpace& AnisotropicHalfSpace::operator=(AnisotropicHalfSpace&&) noexcept = default;
AnisotropicHalfSpace::~AnisotropicHalfSpace() = default;

LineResponse AnisotropicHalfSpace::along(Direction psi) const {
  const internal::AnisotropicAnswers answers = implementation_->at(psi);
  return {answers.compliance, answers.coupling, answers.coupling_across, answers.shear_compliance,
          answers.shear_compliance_across};
}

PressureWave AnisotropicHalfSpace::inside(Direction psi) const {
  const LineResponse surface = along(psi);  // refuses what is not subcritical
  return {surface, *implementation_->line.decay(psi, implementation_->motion)};
}

ShearResponse AnisotropicHalfSpace::shear_along(Direction psi) const {
  const internal::AnisotropicAnswers answers = implementation_->at(psi);
  return {answers.in_line, answers.across};
}

double rayleigh_speed(const data::Stiffness& solid, Direction motion, Direction psi) {
  internal::check_direction("motion", motion);
  internal::check_direction("psi", psi);
  return internal::speed_of_motion(checked_line(solid), motion, psi);
}

CriticalSpeed critical_speed(const data::Stiffness& solid, Direction motion) {
  internal::check_direction("motion", motion);
  constexpr std::size_t most_lines = 800;  // up to ten milliseconds each
  return internal::critical_speed(internal::critical_line(checked_line(solid), solid, motion, most_lines),
                                  motion);
}

}  // namespace nipref::fast
