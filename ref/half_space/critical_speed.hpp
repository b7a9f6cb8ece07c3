#pragma once
#include <optional>

#include <nipref/ref/half_space/direction.hpp>
#include <nipref/ref/half_space/stiffness.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

/// Speeds at which a load that moves in the direction `motion` is critical for the lines of the direction `psi`. The
/// speed v of a load is the phase speed v |cos(psi - theta)| along the line. Bad arguments throw data::BadInput:
/// "psi" where it is perpendicular to the motion; "solid" where no proof is found, because moduli differ by many
/// powers of ten or the surface wave is close to the limiting speed; "digits" unless 16 <= digits <= 1000.

/// The limiting speed: the smallest at which a root s of Stroh's sextic is real, density v^2 cos^2(psi - theta) = min
/// over real s of the smallest eigenvalue of q + s (r + r^T) + s^2 t at rest. Proven: ref/half_space/README.md, Speeds of
/// lines. Horizontally polarised waves count, even without a part in the normal response; see sagittal_stiffness.
Enclosure limiting_speed(const ExactStiffness& solid, const SurfaceDirection& motion,
                         const SurfaceDirection& psi, int digits);

/// The speed of the surface wave, at which det M = 0 and the compliance has its pole. Proven: the same page. Nothing if, to
/// these digits, no such wave is slower than the limiting speed; next to directions in which the limiting wave itself has a
/// traction-free surface the two are arbitrarily close.
std::optional<Enclosure> surface_wave_speed(const ExactStiffness& solid, const SurfaceDirection& motion,
                                            const SurfaceDirection& psi, int digits);

/// acos(v_R/v), for a solid whose lines are all alike and a load at least as fast as the surface wave: the angle from
/// the motion within which the load moves along the lines faster than that wave. In degrees, proven. BadInput "speed"
/// unless it is at least v_R, "solid" where no surface wave exists or its speed is not proven. (brock2012 55)
Enclosure separation_degrees(const ExactStiffness& solid, const Exact& speed, int digits);

/// The smallest speed at which the lines of some direction are critical, and that direction.
struct CriticalSpeed {
  Estimate speed;
  double psi_degrees;  ///< in (theta - 90, theta + 90), with an error of about 1e-8
};

/// The minimum over psi of the surface wave's speed, or of the limiting speed where there is no surface wave. Slower
/// loads are subcritical. It is proven, to the digits given, that the value is at least the minimum. Apart from
/// rounding in double it is proven that no other local minimum is lower by more than 1e-9 of the value (1e-6 or 1e-3
/// where the fastest waves are many times as fast: see lowest_lines). The error of the minimiser is estimated from
/// the curvature. digits: 16 to 508. BadInput "motion" where the minimum is not smooth, for example where the surface
/// waves of some lines reach the limiting speed; "solid" where moduli differ too much to search the lines.
/// (brock2013, end of sec. 4)
CriticalSpeed critical_speed(const ExactStiffness& solid, const SurfaceDirection& motion, int digits);

/// BadInput "speed", which says the critical speed, unless lines of the direction psi are proven to be subcritical: the
/// impedance exists and is positive definite. Speeds within about 1e-30 of the critical one are refused.
void check_subcritical(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion,
                       const SurfaceDirection& psi);

/// The same for the line that is critical first, which is found as for critical_speed().
void check_subcritical(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion);

/// Plane bulk waves along a direction of the surface, unit sqrt(modulus/density).
enum class BulkWave {
  upright,  ///< polarised nearest to the surface's normal
  faster,   ///< of the two others
  slower
};

/// density v^2 is an eigenvalue of n_j C_ijkl n_l. The error follows from the residual of the eigenpair, with an
/// allowance for rounding. It is not proven, as it is the distance from the nearest eigenvalue, whichever that is.
/// BadInput "digits" unless 16 <= digits <= 1000.
Estimate bulk_wave_speed(const ExactStiffness& solid, const SurfaceDirection& direction, BulkWave wave,
                         int digits);

}  // namespace nipref::ref
