#pragma once
#include <cstddef>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/internal/anisotropic_line.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>

namespace nipref::fast::internal {

/// The speed along `motion` at which the line psi is critical; infinite across the motion.
double speed_of_motion(const LineLimits& line, Direction motion, Direction psi);

/// The critical speed `speed` of the line at the angle psi - theta = from_motion, with its psi.
CriticalSpeed critical_at(double speed, double from_motion, Direction motion);

/// The line that is critical first, of a solid with these plane waves. Apart from rounding in double it is proven that
/// no line has a critical speed lower by more than 1e-3, 1e-6, 1e-9 or 1e-12 of it, whichever is the smallest for which
/// 400 lines suffice. BadInput "solid" if the fastest wave along the surface is more than 3000 times as fast, or if
/// `most_lines` lines do not suffice.
CriticalSpeed critical_speed(const LineLimits& line, const AnisotropicLine& waves, Direction motion,
                             std::size_t most_lines);

/// The refusal of a speed that is not below the critical one.
data::BadInput supercritical(double speed, const CriticalSpeed& critical);

}  // namespace nipref::fast::internal
