#pragma once
#include <nipref/data/material/solids.hpp>
#include <nipref/fast/half_space/direction.hpp>
#include <nipref/fast/number/internal/two_words_algebra.hpp>

namespace nipref::fast::internal {

/// The functions that make up the response of an isotropic half-space along one line. Each has two words, since its
/// terms cancel more and more towards the Rayleigh speed. wS^2 = 1 - X, wD^2 = 1 - X/cD^2.
struct IsotropicLine {
  Two X;               ///< density c_X^2/shear, c_X the speed along the line
  Two shear_decay;     ///< wS
  Two pressure_decay;  ///< wD
  Two defect;          ///< (1 - wS wD)/X, finite at rest
  Two rayleigh;        ///< R/X, finite at rest
  Two coupling;        ///< (2 - X - 2 wS wD)/X, finite at rest
};

/// cD^-2 = (1 - 2 nu)/(2 - 2 nu)
Two inverse_squared_pressure_speed(double poisson);

/// v_R/v_S, the root of R, to two words; the domain is that of isotropic_rayleigh_speed().
Two rayleigh_speed_in_two_words(double poisson);

/// Arguments and bad input as of isotropic_response().
IsotropicLine isotropic_line(const data::IsotropicSolid& solid, double speed, Direction from_motion);

}  // namespace nipref::fast::internal
