#pragma once
#include <array>
#include <complex>
#include <cstddef>
#include <functional>

#include <nipref/fast/half_space/direction.hpp>

namespace nipref::fast {

/// The response, in 1/stress, of the surface of a half-space x3 > 0 to a steadily moving load that depends only on the
/// coordinate x along a line: du3/dx = -compliance H[sigma33] - coupling tau - coupling_across tau' -
/// shear_compliance H[tau] - shear_compliance_across H[tau'] with H[f] = (1/pi) vp int f(xi)/(xi - x) dxi. Here tau =
/// sigma_3x is the shear traction along the line and tau' that across it, 90 degrees from x as x2 is from x1.
/// (brock2012 18a, brock2013 14)
struct LineResponse {
  double compliance, coupling;
  double coupling_across = 0;  ///< 0 unless the solid distinguishes left and right of the line
  // Both are 0 if x3 = const is a plane of symmetry of the solid.
  double shear_compliance = 0, shear_compliance_across = 0;
};

/// The response of the surface in the direction of a shear traction tau, 1/stress: du/dx = -in_line H[tau] along the
/// line for tau along the line, du/dx = -across H[tau] across the line for tau across it.
struct ShearResponse {
  double in_line, across;
};

/// The response of two bodies to the tractions between them, whose shear tractions are opposite. (brock2013 25b-c)
inline LineResponse in_contact(const LineResponse& lower, const LineResponse& upper) {
  return {lower.compliance + upper.compliance, lower.coupling - upper.coupling,
          lower.coupling_across - upper.coupling_across, lower.shear_compliance - upper.shear_compliance,
          lower.shear_compliance_across - upper.shear_compliance_across};
}

/// The response of the two bodies of a contact, combined by in_contact, along the lines of each direction. Opposite
/// directions have the same compliance, the same couplings, and shear compliances of opposite sign.
using SurfaceResponse = std::function<LineResponse(Direction)>;

/// The displacement inside the half-space under a wave of pressure e^{ikx} along a line, k > 0. At the depth z it is
/// e^{ikx}/k times f[g0] v0 + f[g0, g1] v1 + f[g0, g1, g2] v2 along the line, across it and downwards, with divided
/// differences of f(g) = e^{-gkz}. This is e^{-Gkz} v0 for a matrix G with eigenvalues g, some of which may be equal.
struct PressureWave {
  using Vector = std::array<std::complex<double>, 3>;

  Vector decays;                 ///< g, Re g > 0; if there are two, the second twice
  std::array<Vector, 3> shares;  ///< v, 1/stress
  std::size_t count = 1;         ///< number of shares that are not 0

  /// For the surface alone.
  PressureWave(const LineResponse& y)
      : decays{},
        shares{{{std::complex(y.shear_compliance, y.coupling),
                 std::complex(y.shear_compliance_across, y.coupling_across), y.compliance}}} {}
  /// For any depth, from G in the same axes, by rows.
  PressureWave(const LineResponse& y, const std::array<Vector, 3>& matrix);
};
using PressureWaves = std::function<PressureWave(Direction)>;

}  // namespace nipref::fast
