#pragma once
#include <nipref/data/material/solids.hpp>
#include <nipref/fast/half_space/response.hpp>

namespace nipref::fast {

// The surface of an isotropic half-space under loads that move steadily.
//
//   speed         >= 0, unit of sqrt(shear/density), which is the speed v_S of shear waves. The squared ratio of the
//                 two is computed in two words
//   from_motion   direction of the line relative to the direction of motion, psi - theta, a unit vector. Along the line
//                 the load moves at speed |cos(psi - theta)|, which has to be below the Rayleigh speed
//   accuracy      two units in the last place, from rest to 1 - 1e-12 of the Rayleigh speed
//   bad input     a solid that fails its check(), nan, infinite, speed < 0, supercritical: data::BadInput

/// Compliance and coupling to the shear along the line, 1/stress. They are X wD/(mu R) and (2 - X - 2 wS wD)/(mu R), where
/// X = c_X^2, wS^2 = 1 - X, wD^2 = 1 - X/cD^2 and R = 4 wS wD - (2 - X)^2. (brock2012 18a)
LineResponse isotropic_response(const data::IsotropicSolid& solid, double speed, Direction from_motion);

/// The response inside the half-space: u3 = wD/(mu R) (2 e^{-wS kz} - (2 - X) e^{-wD kz})/k and, along the line,
/// i/(mu R) ((2 - X) e^{-wD kz} - 2 wS wD e^{-wS kz})/k. (brock2012 17)
PressureWave isotropic_pressure_wave(const data::IsotropicSolid& solid, double speed, Direction from_motion);

/// The response between the Rayleigh speed and the speed of shear waves along the line. There K < 0: the surface rises
/// under pressure. BadInput at other speeds. (brock2012 section 8)
LineResponse isotropic_response_beyond(const data::IsotropicSolid& solid, double speed,
                                       Direction from_motion);

/// The index (1/pi) ln sqrt((q + 1)/(q - 1)) of a line between these speeds, q = |S|/sqrt(K X wS/R) > 1. The tractions of a
/// rolling sphere end there like (x+ - x)^(+-i index) (x - x-)^(-+i index), without a root. (brock2012 56)
double rolling_index_beyond(const data::IsotropicSolid& solid, double speed, Direction from_motion);

/// d ln K/d ln speed, the condition number of the compliance with respect to the speed. It grows without bound
/// towards the Rayleigh speed.
double isotropic_condition(const data::IsotropicSolid& solid, double speed, Direction from_motion);

/// X wS/(mu R) along the line and 1/(mu wS) across it.
ShearResponse isotropic_shear_response(const data::IsotropicSolid& solid, double speed,
                                       Direction from_motion);

/// v_R/v_S, the root of R, rounded down to a double: the critical speed. -1 < poisson < 1/2; BadInput otherwise.
double isotropic_rayleigh_speed(double poisson);

}  // namespace nipref::fast
