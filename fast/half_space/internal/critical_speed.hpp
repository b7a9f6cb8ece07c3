#pragma once
#include <cstddef>

#include <nipref/data/material/stiffness.hpp>
#include <nipref/fast/half_space/internal/line_limits.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>

namespace nipref::fast::internal {

/// The speed along `motion` at which the line psi is critical; infinite across the motion.
double speed_of_motion(const LineLimits& line, Direction motion, Direction psi);

struct CriticalLine {
  double speed;        ///< along the motion
  double from_motion;  ///< psi - theta
};

/// The line that is critical first. Apart from rounding in double it is proven that no line has a critical speed
/// lower by more than 1e-3, 1e-6, 1e-9 or 1e-12 of it, whichever is the smallest that 400 lines suffice for. BadInput
/// "solid" where the fastest wave along the surface is 3000 times as fast, or where `most_lines` lines do not
/// suffice.
CriticalLine critical_line(const LineLimits& line, const data::Stiffness& solid, Direction motion,
                           std::size_t most_lines);

/// The same with the line's angle psi from x1, -pi/2 < psi <= pi/2.
CriticalSpeed critical_speed(const CriticalLine& critical, Direction motion);

}  // namespace nipref::fast::internal
