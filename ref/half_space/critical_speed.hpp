#pragma once
#include <optional>

#include <nipref/ref/half_space/direction.hpp>
#include <nipref/ref/half_space/stiffness.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

// Speeds at which a load that moves in the direction `motion`, at the angle theta, is critical for the lines of the
// direction `psi`. A load of speed v has the phase speed v |cos(psi - theta)| along the line. The functions throw
// data::BadInput: "psi" if it is perpendicular to the motion; "solid" if no proof is found, because moduli differ by
// many powers of ten or the surface wave is close to the limiting speed; "digits" unless 16 <= digits <= 1000.

/// The limiting speed: the smallest speed v at which a root s of Stroh's sextic is real. There density v^2 cos^2(psi -
/// theta) is the minimum over real s of the smallest eigenvalue of q + s (r + r^T) + s^2 t at rest. Horizontally
/// polarised waves count even where the normal response does not contain them, see sagittal_stiffness. Proven:
/// ref/half_space/README.md, Speeds of lines.
Enclosure limiting_speed(const ExactStiffness& solid, const SurfaceDirection& motion,
                         const SurfaceDirection& psi, int digits);

/// The speed of the surface wave, at which det M = 0 and the compliance has its pole. Proven on the same page. Nothing
/// if, to these digits, no surface wave is slower than the limiting speed. The two speeds are arbitrarily close next to
/// directions in which the limiting wave itself has a traction-free surface.
std::optional<Enclosure> surface_wave_speed(const ExactStiffness& solid, const SurfaceDirection& motion,
                                            const SurfaceDirection& psi, int digits);

/// acos(v_R/v) in degrees, the angle from the motion within which the phase speed exceeds the surface wave's speed v_R,
/// for a solid whose lines are all alike. Proven. BadInput "speed" unless the speed v of the load is at least v_R,
/// "solid" if no surface wave exists or its speed is not proven. (brock2012 55)
Enclosure separation_degrees(const ExactStiffness& solid, const Exact& speed, int digits);

/// The smallest speed at which the lines of some direction are critical, and that direction.
struct CriticalSpeed {
  Estimate speed;
  double psi_degrees;  ///< in (theta - 90, theta + 90), with an error of about 1e-8
};

/// The minimum over psi of the surface wave's speed, or of the limiting speed where there is no surface wave. Slower
/// loads are subcritical. It is proven, to the digits given, that the value is at least the minimum. Apart from
/// rounding in double it is proven that no other local minimum is lower by more than 1e-9 of the value (1e-6 or 1e-3 if
/// the fastest waves are many times as fast, see lowest_lines in critical_speed.cpp). The effect of the minimiser's
/// error is estimated from the curvature. digits: 16 to 508. BadInput "motion" if the minimum is not smooth, for
/// example because the surface waves of some lines reach the limiting speed; "solid" if moduli differ too much to
/// search the lines. (brock2013, end of sec. 4)
CriticalSpeed critical_speed(const ExactStiffness& solid, const SurfaceDirection& motion, int digits);

/// Throws BadInput "speed", with the critical speed in its message, unless lines of the direction psi are proven to be
/// subcritical: the impedance exists and is positive definite. Speeds within about 1e-30 of the critical are refused.
void check_subcritical(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion,
                       const SurfaceDirection& psi);

/// The same for the line with the smallest critical speed, which is found as for critical_speed().
void check_subcritical(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion);

/// Plane bulk waves along a direction of the surface, unit sqrt(modulus/density).
enum class BulkWave {
  upright,  ///< polarised nearest to the surface's normal
  faster,   ///< the faster of the two others
  slower
};

/// The speed v of a bulk wave: density v^2 is an eigenvalue of n_j C_ijkl n_l. The error is computed from the residual
/// of the eigenpair, with an allowance for rounding. It bounds the distance from the nearest eigenvalue, but it is not
/// proven that this is the eigenvalue of the wave. BadInput "digits" unless 16 <= digits <= 1000.
Estimate bulk_wave_speed(const ExactStiffness& solid, const SurfaceDirection& direction, BulkWave wave,
                         int digits);

}  // namespace nipref::ref
