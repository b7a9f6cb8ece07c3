#pragma once
#include <nipref/fast/half_space/internal/line_limits.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>

namespace nipref::fast::internal {

/// The speed along `motion` at which the line psi is critical; infinite across the motion.
double speed_of_motion(const LineLimits& line, Direction motion, Direction psi);

struct CriticalLine {
  double speed;        ///< along the motion
  double from_motion;  ///< psi - theta
};

/// The line that is critical first. Speeds are compared at steps of a degree, and at finer ones wherever that
/// leaves room for a lower one, as steep as they are there.
CriticalLine critical_line(const LineLimits& line, Direction motion);

/// With the angle from x1, -pi/2 < psi <= pi/2.
CriticalSpeed critical_speed(const CriticalLine& critical, Direction motion);

}  // namespace nipref::fast::internal
