#pragma once
#include <memory>

#include <nipref/data/material/solids.hpp>
#include <nipref/fast/half_space/response.hpp>

namespace nipref::fast {

// The surface of a transversely isotropic half-space under loads that move steadily.
//
//   solid         any with positive strain energy (its check())
//   axis          normal: axis 3 of the solid is the normal of the surface. in_plane: axis 3 is the direction of
//                 90 degrees in the surface
//   motion, psi   directions of motion and line, unit vectors. Along the line the load moves at speed
//                 |cos(psi - theta)|
//   speed         in SpeedUnit, unit of sqrt(modulus/density)
//   bad input     a solid that fails its check(), or whose matrix has a condition number above 1e12, nan,
//                 infinite, directions that are not unit vectors, a speed that is negative or not subcritical on
//                 every line: data::BadInput

/// The unit of speeds as a sum of two words, since its rounding to one word would cause an error of every speed.
struct SpeedUnit {
  double high = 1, low = 0;
};

struct CriticalSpeed {
  double speed;
  double psi;  ///< the line that is critical first, radians, -pi/2 < psi <= pi/2
};

class TransverselyIsotropicHalfSpace {
 public:
  /// Takes some milliseconds, as it computes the critical speed.
  TransverselyIsotropicHalfSpace(const data::TransverselyIsotropicSolid& solid, data::SymmetryAxis axis,
                                 Direction motion, double speed, SpeedUnit unit = {});

  /// Compliance and couplings to the shear along and across the line, each to two units in the last place, up to
  /// 1 - 1e-12 of the critical speed. A call takes a quarter of a microsecond. (brock2013 19, 25b; 43 and 44 corrected,
  /// couplings added)
  [[nodiscard]] LineResponse along(Direction psi) const;

  /// Takes about 60 microseconds.
  [[nodiscard]] PressureWave inside(Direction psi) const;

  /// d ln K/d ln speed, the condition number of the compliance with respect to the speed. It grows without bound towards
  /// the critical speed. Its error is at most 3e-13 max(1, condition number) up to 1 - 1e-8 of the critical speed.
  [[nodiscard]] double condition(Direction psi) const;

  /// The smallest critical speed, in the unit of the speed; see critical_speed() below.
  [[nodiscard]] double critical_speed() const;

 private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

/// The smallest speed at which some line is critical: the minimum over the lines of the speed of the Rayleigh wave along
/// the line or, if there is none, of the slowest bulk wave in its field. The speed is right to a few units in the last
/// place, psi to 1e-7. With a normal axis all lines are alike, and psi is the angle of the motion. BadInput "solid" also
/// if the fastest wave is more than 3000 times as fast as the critical speed, as the search would take too long.
CriticalSpeed critical_speed(const data::TransverselyIsotropicSolid& solid, data::SymmetryAxis axis,
                             Direction motion);

/// The speed along `motion` at which the line psi is critical: the root of M or, if M has none, the branch point. It is
/// right to a few units in the last place, and infinite for a line across the motion.
double rayleigh_speed(const data::TransverselyIsotropicSolid& solid, data::SymmetryAxis axis,
                      Direction motion, Direction psi);

/// Bulk waves along a line in a surface that contains the axis. (brock2013 46)
enum class BranchWave {
  transverse,          ///< (46a), polarised across the axis and the line: root of B5, and of B6
  quasi_longitudinal,  ///< (46b), plus
  quasi_transverse     ///< (46b), minus
};

/// The speed of such a wave along the line of motion, to a unit in the last place. The printed P6 is wrong; correct is
/// P6^2 = 4 d6 P + [(d6 - d1)(d6 - d2) - (d6 + d12)^2] sin^2(2 theta).
double branch_speed(BranchWave wave, const data::TransverselyIsotropicSolid& solid, Direction motion);

}  // namespace nipref::fast
