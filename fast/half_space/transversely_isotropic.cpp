#include <cmath>

#include <nipref/fast/half_space/internal/critical_speed.hpp>
#include <nipref/fast/half_space/internal/transversely_isotropic_line.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/fast/number/internal/checks.hpp>

namespace nipref::fast {
namespace {

using internal::check_direction;
using internal::Two;

internal::TransverselyIsotropicLine checked_line(const data::TransverselyIsotropicSolid& solid,
                                                 data::SymmetryAxis axis) {
  solid.check();
  internal::check_moduli(data::Stiffness::of(solid, axis));
  return {solid, axis};
}

/// The solid as a general anisotropic one. With a normal axis c66 does not affect the motion under pressure. It is
/// replaced by c11: then waves polarised across the line are as fast as longitudinal ones and never radiate.
internal::AnisotropicLine general_line(const data::TransverselyIsotropicSolid& solid,
                                       data::SymmetryAxis axis) {
  data::Stiffness general = data::Stiffness::of(solid, axis);
  if (axis == data::SymmetryAxis::normal) {
    general.voigt[5][5] = solid.c11;
    general.voigt[0][1] = general.voigt[1][0] = -solid.c11;
  }
  return internal::AnisotropicLine(general);
}

CriticalSpeed first_critical(const internal::TransverselyIsotropicLine& line,
                             const internal::AnisotropicLine& general, data::SymmetryAxis axis,
                             Direction motion) {
  check_direction("motion", motion);
  if (axis == data::SymmetryAxis::normal) return internal::critical_at(line.limit(motion), 0, motion);
  constexpr std::size_t most_lines = 8000;  // some ten microseconds each
  return internal::critical_speed(line, general, motion, most_lines);
}

}  // namespace

struct TransverselyIsotropicHalfSpace::Implementation {
  internal::TransverselyIsotropicLine line;
  internal::AnisotropicLine general;
  internal::Motion motion;
  double speed, critical;

  [[nodiscard]] LineResponse at(Direction psi) const {
    check_direction("psi", psi);
    const std::optional<LineResponse> answers = line.at(psi, motion);
    // The critical speed found by the search may be too high by a few roundings.
    if (!answers) throw data::BadInput("speed", speed, "must be subcritical on the line");
    return *answers;
  }
};

TransverselyIsotropicHalfSpace::TransverselyIsotropicHalfSpace(const data::TransverselyIsotropicSolid& solid,
                                                               data::SymmetryAxis axis, Direction motion,
                                                               double speed, SpeedUnit unit) {
  internal::check_not_negative("speed", speed);
  const internal::TransverselyIsotropicLine line = checked_line(solid, axis);
  const internal::AnisotropicLine general = general_line(solid, axis);
  CriticalSpeed critical = first_critical(line, general, axis, motion);
  critical.speed /= unit.high;
  if (speed >= critical.speed) throw internal::supercritical(speed, critical);
  implementation_ = std::make_shared<const Implementation>(
      Implementation{line, general, {motion, speed * Two{unit.high, unit.low}}, speed, critical.speed});
}

LineResponse TransverselyIsotropicHalfSpace::along(Direction psi) const { return implementation_->at(psi); }

PressureWave TransverselyIsotropicHalfSpace::inside(Direction psi) const {
  const LineResponse surface = along(psi);
  const auto decay = implementation_->general.decay(psi, implementation_->motion);
  if (!decay) throw data::BadInput("speed", implementation_->speed, "must be subcritical on the line");
  return {surface, *decay};
}

double TransverselyIsotropicHalfSpace::condition(Direction psi) const {
  static_cast<void>(implementation_->at(psi));  // throws for a psi or a line that is not allowed
  const auto& [line, general, motion, speed, critical] = *implementation_;
  const double condition = line.condition(psi, motion);
  if (!std::isfinite(condition))
    throw data::BadInput("speed", speed, "must be farther from the critical speed than a rounding");
  return condition;
}

double TransverselyIsotropicHalfSpace::critical_speed() const { return implementation_->critical; }

CriticalSpeed critical_speed(const data::TransverselyIsotropicSolid& solid, data::SymmetryAxis axis,
                             Direction motion) {
  return first_critical(checked_line(solid, axis), general_line(solid, axis), axis, motion);
}

double rayleigh_speed(const data::TransverselyIsotropicSolid& solid, data::SymmetryAxis axis,
                      Direction motion, Direction psi) {
  check_direction("motion", motion);
  check_direction("psi", psi);
  return internal::speed_of_motion(checked_line(solid, axis), motion, psi);
}

double branch_speed(BranchWave wave, const data::TransverselyIsotropicSolid& solid, Direction motion) {
  solid.check();
  check_direction("motion", motion);
  const Two cos2 = square(internal::cosine_of(motion)) / internal::squared_length(motion),
            sin2 = square(internal::sine_of(motion)) / internal::squared_length(motion);
  if (wave == BranchWave::transverse) {
    return std::sqrt(rounded(solid.c66 * cos2 + solid.c44 * sin2) / solid.density);
  }
  // Christoffel's matrix in the plane of line and axis
  const Two along = solid.c11 * cos2 + solid.c44 * sin2, across = solid.c44 * cos2 + solid.c33 * sin2;
  const Two mixed = internal::two_sum(solid.c44, solid.c13) *
                    (internal::cosine_of(motion) * internal::sine_of(motion)) /
                    internal::squared_length(motion);
  const double half_difference = rounded(along - across) / 2;
  const double larger = rounded(along + across) / 2 + std::hypot(half_difference, rounded(mixed));
  if (wave == BranchWave::quasi_longitudinal) return std::sqrt(larger / solid.density);
  return std::sqrt(rounded(along * across - square(mixed)) / larger / solid.density);
}

}  // namespace nipref::fast
