#pragma once
#include <memory>

#include <nipref/data/material/stiffness.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/response.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>

namespace nipref::fast {

// The surface of a half-space of any anisotropy under loads that move steadily. (brock2013 A.1-A.5)
//
//   solid         its 21 constants, positive definite (its check())
//   motion, psi   directions of motion and line, unit vectors. The line sees speed |cos(psi - theta)|
//   speed         unit of sqrt(modulus/density), >= 0
//   accuracy      of the largest of compliance, in_line and across: a few units in the last place, up to 1 - 1e-9 of
//                 the line's critical speed, for moduli within some four decades
//   bad input     a solid that fails its check(), or whose matrix has eigenvalues more than 1e12 apart, nan, infinite,
//                 directions that are no unit vectors, a line that is not subcritical: data::BadInput

/// Some 60 microseconds.
class AnisotropicHalfSpace {
 public:
  AnisotropicHalfSpace(const data::Stiffness& solid, Direction motion, double speed);
  AnisotropicHalfSpace(AnisotropicHalfSpace&&) noexcept;
  AnisotropicHalfSpace& operator=(AnisotropicHalfSpace&&) noexcept;
  ~AnisotropicHalfSpace();

  [[nodiscard]] LineResponse along(Direction psi) const;
  /// In the own direction of the shear.
  [[nodiscard]] ShearResponse shear_along(Direction psi) const;

 private:
  struct Implementation;
  std::unique_ptr<const Implementation> implementation_;
};

/// The speed along `motion` at which the line psi is critical: by the surface wave, or the bulk wave that it would have to
/// be slower than; a few units in the last place. Infinite for a line across the motion.
double rayleigh_speed(const data::Stiffness& solid, Direction motion, Direction psi);

/// The smallest speed at which some line is critical, by a surface wave or else by a bulk wave; the minimum over the
/// lines, some hundredths of a second: speed to a few units in the last place, psi to 1e-7. BadInput "solid" also where
/// the search of the lines would take too long, from a fastest wave 3000 times as fast on.
CriticalSpeed critical_speed(const data::Stiffness& solid, Direction motion);

}  // namespace nipref::fast
