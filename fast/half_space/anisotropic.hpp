#pragma once
#include <memory>

#include <nipref/data/material/stiffness.hpp>
#include <nipref/fast/half_space/response.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>

namespace nipref::fast {

// The surface of a half-space of any anisotropy under loads that move steadily. (brock2013 A.1-A.5)
//
//   solid         its 21 constants, positive definite (its check())
//   motion, psi   directions of motion and line, unit vectors. Along the line the load moves at speed
//                 |cos(psi - theta)|
//   speed         unit of sqrt(modulus/density), >= 0
//   accuracy      a few units in the last place of the largest of compliance, in_line and across, up to 1 - 1e-9 of
//                 the line's critical speed, for moduli that differ by up to some four decades
//   bad input     a solid that fails its check(), or whose matrix has a condition number above 1e12, nan, infinite,
//                 directions that are not unit vectors, a line that is not subcritical: data::BadInput

/// The responses of one solid at one speed. A line takes about 60 microseconds.
class AnisotropicHalfSpace {
 public:
  AnisotropicHalfSpace(const data::Stiffness& solid, Direction motion, double speed);

  [[nodiscard]] LineResponse along(Direction psi) const;
  [[nodiscard]] PressureWave inside(Direction psi) const;
  /// The response in the direction of the shear itself.
  [[nodiscard]] ShearResponse shear_along(Direction psi) const;

 private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

/// The speed along `motion` at which the line psi becomes critical, by the surface wave along the line or, if there is
/// none, by the slowest bulk wave. It is right to a few units in the last place, and infinite for a line across the motion.
double rayleigh_speed(const data::Stiffness& solid, Direction motion, Direction psi);

/// The smallest speed at which some line is critical: the minimum of rayleigh_speed() over all lines. The speed is
/// right to a few units in the last place, psi to 1e-7. The search takes some hundredths of a second; if it would take
/// too long, as the fastest wave is more than 3000 times as fast as the critical speed, BadInput "solid" is thrown.
CriticalSpeed critical_speed(const data::Stiffness& solid, Direction motion);

}  // namespace nipref::fast
