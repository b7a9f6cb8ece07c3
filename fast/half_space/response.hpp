#pragma once
#include <functional>

#include <nipref/fast/half_space/direction.hpp>

namespace nipref::fast {

/// What the surface of a half-space x3 > 0 answers along the lines x of one direction, when a load that
/// depends on x only moves steadily: du3/dx = -compliance H[sigma33] - coupling tau - coupling_across tau' -
/// shear_compliance H[tau] - shear_compliance_across H[tau'] with H[f] = (1/pi) vp int f(xi)/(xi - x) dxi, tau =
/// sigma_3x the shear traction along the line and tau' that across it, 90 degrees from x as x2 is from x1. In
/// 1/stress. (brock2012 18a, brock2013 14)
struct LineResponse {
  double compliance, coupling;
  double coupling_across = 0;  ///< 0 unless the solid distinguishes left and right of the line
  // Both 0 where x3 = const is a plane of symmetry of the solid.
  double shear_compliance = 0, shear_compliance_across = 0;
};

/// The answer to what acts between two bodies: the shear on one is the reaction on the other. (brock2013
/// 25b-c)
inline LineResponse in_contact(const LineResponse& lower, const LineResponse& upper) {
  return {lower.compliance + upper.compliance, lower.coupling - upper.coupling,
          lower.coupling_across - upper.coupling_across, lower.shear_compliance - upper.shear_compliance,
          lower.shear_compliance_across - upper.shear_compliance_across};
}

/// What a contact needs to know of its two bodies: their answer along the lines of each direction, already
/// joined by in_contact. Opposite directions have the same compliance and the same
/// couplings, and shear compliances of opposite sign.
using SurfaceResponse = std::function<LineResponse(Direction)>;

}  // namespace nipref::fast
