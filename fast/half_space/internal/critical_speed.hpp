#pragma once
#include <nipref/fast/half_space/internal/transversely_isotropic_line.hpp>

namespace nipref::fast::internal {

/// The speed along `motion` at which the line psi is critical; infinite across the motion.
double speed_of_motion(const TransverselyIsotropicLine& line, Direction motion, Direction psi);

struct CriticalLine {
  double speed;        ///< along the motion
  double from_motion;  ///< psi - theta
};

/// The line that is critical first. Speeds are compared at steps of a degree, and at finer ones wherever that
/// leaves room for a lower one, as steep as they are there.
CriticalLine critical_line(const TransverselyIsotropicLine& line, Direction motion);

}  // namespace nipref::fast::internal
