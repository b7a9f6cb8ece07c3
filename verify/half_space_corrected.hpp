#pragma once
#include <functional>

#include "data/half_space_solids.hpp"
#include "fast/surface_line.hpp"

namespace nipref::verify {

// The formulas of the half-space papers as they should read. Speeds are in the unit of sqrt(modulus/density),
// and subcritical; `line_speed` is the speed of the load times the cosine between the line and the motion.

/// Compliance X w_D/R and coupling -N/R over mu, X = (line_speed/v_S)^2, 1 - nu and (1 - 2 nu)/2 at rest.
/// (brock2012 18a)
fast::LineResponse corrected_line_response(const data::IsotropicSolid& solid, double line_speed);

/// Axis of symmetry normal to the surface: A1 P+/(M sqrt(d3 d5)) and N/M. (brock2013 19, 25b)
fast::LineResponse corrected_line_response(const data::TransverselyIsotropicSolid& solid, double line_speed);

/// Axis in the surface, along x2; 1/stress. (brock2013 43), with the sign and the term of M that the print
/// lacks.
double corrected_in_plane_compliance(const data::TransverselyIsotropicSolid& solid, fast::Direction line,
                                     double line_speed);

/// What two bodies in contact answer together when the upper one carries the opposite shear: compliances
/// add, couplings subtract. (brock2013 25b, 25c with a minus sign)
fast::LineResponse in_contact(const fast::LineResponse& lower, const fast::LineResponse& upper);

/// The papers' span of contact along a line but for a factor that is common to all lines: h/Q with h =
/// sqrt(K^2 + (g S)^2), Q = (1 + Omega)^(1 + Omega) (-Omega)^(-Omega), Omega = -1/2 + atan(g S/K)/pi;
/// `friction_along` is g, the coefficient of friction times the cosine between line and motion. A postulate
/// of the papers, not the span of the exact contact. (brock2012 34a, brock2013 34)
double contour_span(const fast::LineResponse& response, double friction_along);

/// Span across over span along, both through the centre, of the exact frictionless contact of a sphere with a
/// surface of that compliance: the ellipse of half-widths w(psi) for which int K n n/w^3 dpsi is a multiple
/// of the unit matrix. Within 1e-9 where the compliance is smooth and varies by less than a factor of 3.
double exact_span_ratio(const std::function<double(fast::Direction)>& compliance, fast::Direction along,
                        fast::Direction across);

/// L2/L1 of the sphere rolling without slip, by the same rule; speed = v/v_S. (brock2012 53b)
double corrected_rolling_span_ratio(double poisson, double speed);

/// Speeds at which roots of the half-space's waves have branch points for the line of motion, axis in the
/// surface along x2. (brock2013 46)
struct BranchSpeeds {
  double c_56, c_plus, c_minus;
};
BranchSpeeds corrected_branch_speeds(const data::TransverselyIsotropicSolid& solid, fast::Direction motion);

}  // namespace nipref::verify
