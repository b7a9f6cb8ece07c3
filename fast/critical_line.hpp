#pragma once
#include <nipref/fast/surface_line.hpp>
#include <nipref/fast/transversely_isotropic_line.hpp>

namespace nipref::fast::internal {

/// The speed along `motion` at which the line psi is critical; infinite across the motion.
double speed_of_motion(const TransverselyIsotropicLine& line, Direction motion, Direction psi);

struct CriticalLine {
  double speed;        ///< along the motion
  double from_motion;  ///< psi - theta
};

/// The line that is critical first.
CriticalLine critical_line(const TransverselyIsotropicLine& line, Direction motion);

}  // namespace nipref::fast::internal
