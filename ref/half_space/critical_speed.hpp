#pragma once
#include <optional>

#include <nipref/ref/half_space/direction.hpp>
#include <nipref/ref/half_space/stiffness.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

/// Speeds at which a load that moves in the direction `motion` is critical for the lines of the direction
/// `psi`. A speed v stands for the phase speed v |cos(psi - theta)|. Bad arguments throw data::BadInput:
/// "psi" where it is perpendicular to the motion, "solid" where no proof is found, as where moduli are many
/// powers of ten apart or the surface wave is next to the limiting speed, "digits" unless 16 <= digits <= 1000.

/// The limiting speed: the smallest at which a root s of Stroh's sextic is real, density v^2 cos^2(psi -
/// theta) = min over real s of the smallest eigenvalue of q + s (r + r^T) + s^2 t at rest. Proven on both
/// sides: a quotient of Rayleigh above, an impedance that exists (see impedance.hpp) below. Horizontally
/// polarised waves count, even where they have no part in the normal response; see sagittal_stiffness.
Enclosure limiting_speed(const ExactStiffness& solid, const SurfaceDirection& motion,
                         const SurfaceDirection& psi, int digits);

/// The speed of the surface wave, where det M = 0 and the compliance has its pole. Proven by opposite signs
/// of det M in interval arithmetic; M falls with the speed and never has two eigenvalues below 0, so there is
/// no other. Nothing where no such wave is slower than the limiting speed in these digits: next to a
/// direction in which the limiting wave itself leaves the surface free there is one as near to it as one likes.
std::optional<Enclosure> surface_wave_speed(const ExactStiffness& solid, const SurfaceDirection& motion,
                                            const SurfaceDirection& psi, int digits);

/// Where all lines are alike, and for a load faster than the surface wave: acos(v_R/v), the angle from the motion within
/// which lines see more than its speed; degrees, proven. BadInput "speed" unless it is at least v_R, "solid" where there
/// is no surface wave or its proof is missed. (brock2012 55)
Enclosure separation_degrees(const ExactStiffness& solid, const Exact& speed, int digits);

/// The smallest speed at which the lines of some direction are critical, and that direction.
struct CriticalSpeed {
  Estimate speed;
  double psi_degrees;  ///< in (theta - 90, theta + 90), good to some 1e-8
};

/// Minimum over psi of the surface wave's speed, or the limiting one where there is no surface wave. Loads
/// slower than this are subcritical. The value is proven to be no less than the minimum, to its digits; that no
/// other valley is lower by more than 1e-9 of it is proven but for rounding in double (1e-6 or 1e-3 where the
/// fastest waves are many times as fast: see lowest_lines), and the error of the minimiser is estimated from the
/// curvature. digits: 16 to 508. BadInput "motion" where the minimum is not smooth, as where surface waves of some
/// lines end in the limiting speed, "solid" where moduli are too far apart to search the lines. (brock2013, end of
/// sec. 4)
CriticalSpeed critical_speed(const ExactStiffness& solid, const SurfaceDirection& motion, int digits);

/// BadInput "speed", with what is allowed, unless lines of the direction psi are proven to be subcritical at
/// it: the impedance exists and is positive definite. Speeds nearer to the critical one than some 1e-30 of it
/// are refused.
void check_subcritical(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion,
                       const SurfaceDirection& psi);

/// BadInput "speed" unless that is proven of the line that is critical first; which one this is is found as above.
void check_subcritical(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion);

}  // namespace nipref::ref
