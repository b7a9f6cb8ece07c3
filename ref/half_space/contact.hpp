#pragma once
#include <functional>

#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/real.hpp>

namespace nipref::ref {

// Contacts of smooth rigid bodies with half-spaces in multiprecision, from what the surface answers along
// lines. Integrals by quadrature: over a line by a double-exponential rule, over the directions by the
// trapezoidal rule, doubled until two results agree; bounds are those differences, estimated and not proven.
//
//   digits      16 to 100; else BadInput. Results are good to 10^-digits of themselves, or std::runtime_error
//   friction    coefficient, >= 0
//   degrees     angle of a line from the motion

/// K, S, S' and K_nn of the lines of one direction, 1/stress: du3/dx = -compliance H[sigma33] - coupling tau
/// - coupling_across tau', du/dx = -in_line H[tau] + coupling sigma33.
struct LineAnswer {
  Real compliance, coupling, coupling_across, in_line;
};

/// The answer at an angle from the motion in degrees, good to 10^-digits.
using SurfaceAnswer = std::function<LineAnswer(const Exact& degrees, int digits)>;

/// Omega = -1/2 + atan(friction (cos(psi) S - sin(psi) S')/K)/pi: the pressure on a line ends like (x+ -
/// x)^(1 + Omega) (x - x-)^(-Omega). (brock2012 26a, brock2013 29a)
Enclosure sliding_exponent(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                           int digits);

/// A(psi) L(psi)/(A(0) L(0)), A the body's curvature along the line: spans of the contact by the papers'
/// rule, that peak pressures are equal. (brock2012 34a, brock2013 34)
Enclosure sliding_span_ratio(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                             int digits);

/// F3/(C L^3) of a body of equal curvatures C, L its span along the motion; unit of stress: minus the
/// integral of sigma33 |x| over the lines of half a turn. (brock2012 36, brock2013 36 with Q^3)
Enclosure sliding_force(const SurfaceAnswer& surface, const Exact& friction, int digits);

/// P = ln((1 + q)/(1 - q))/(2 pi), q = S/sqrt(K K_nn): how the tractions of rolling without slip oscillate at
/// the ends of a line. (brock2012 43b)
Enclosure rolling_index(const SurfaceAnswer& surface, const Exact& degrees, int digits);

/// L(psi)/L(0) of a rolling sphere by the papers' rule, to first order in span over radius: amplitudes, whose
/// squares go like K_nn/K/(K K_nn - S^2), are equal at the centre. (brock2012 53)
Enclosure rolling_span_ratio(const SurfaceAnswer& surface, const Exact& degrees, int digits);

/// Minor over major axis of the exact frictionless contact of a rigid body whose curvature across the motion
/// is curvature_ratio > 0 times that along it, a sphere for 1: the ellipse whose half-widths w make int K n
/// n/w^3 dpsi proportional to the curvatures. By Newton's method for w^2 = 1 + e cos(2 psi) + f sin(2 psi).
/// Ellipses slenderer than about 1/100 need more lines than are tried: std::runtime_error.
Enclosure elliptic_axis_ratio(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits);

/// F/(sqrt(R) delta^(3/2)) of that contact, 1/R the mean of the two curvatures and delta the approach: (8
/// pi/3) I3^(1/2)/I1^(3/2) with In = int K/w^n dpsi over half a turn; unit of stress. A sphere at rest:
/// Hertz's 8/(3 K).
Enclosure elliptic_stiffness(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits);

}  // namespace nipref::ref
