#pragma once
#include <cmath>

namespace nipref::fast {

/// A direction in the surface of a half-space. Near 90 degrees its cosine keeps all its digits, which no
/// angle in double does: that is where the cross direction of a sliding contact lives.
struct Direction {
  double cosine, sine;

  static Direction of_angle(double psi) { return {std::cos(psi), std::sin(psi)}; }
};

/// What the surface of a half-space x3 > 0 answers along the lines x of one direction, when a load that
/// depends on x only moves steadily: du3/dx = -compliance H[sigma33] - coupling tau with H[f] = (1/pi) vp int
/// f(xi)/(xi - x) dxi, and tau = sigma_3x the shear traction along the line. Both in 1/stress. (brock2012
/// 18a, brock2013 14)
struct LineResponse {
  double compliance, coupling;
};

}  // namespace nipref::fast
