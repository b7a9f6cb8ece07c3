#pragma once
#include <array>
#include <functional>
#include <optional>

#include <nipref/ref/half_space/direction.hpp>
#include <nipref/ref/half_space/stiffness.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// The matrix G: a wave e^{ikx}, k > 0, along a line decays with the depth z like e^{-Gkz}. The entries are in the axes
/// n, t and e3 of LineResponse, row by row.
struct Decay {
  std::array<Float, 9> re, im;
};

/// The response of the surface of an anisotropic half-space x3 > 0 to steadily moving tractions sigma33, tau =
/// sigma_3n and tau' = sigma_3t that depend only on the coordinate x along a direction n; t = e3 x n is the direction
/// across it. With H[f] = (1/pi) vp int f(xi)/(xi - x) dxi,
///
///     du3/dx = -compliance H[sigma33] - coupling tau - coupling_across tau'
///              - shear_compliance H[tau] - shear_compliance_across H[tau'],
///     dun/dx = -in_line H[tau] + ...,   dut/dx = -across H[tau'] + ...
///
/// all in 1/stress. The two shear compliances vanish if x3 = const is a plane of symmetry of the solid. With the
/// inverse Y of the impedance, compliance = Y33, shear_compliance = Re Y3n, coupling = -Im Y3n.
struct LineResponse {
  Enclosure compliance;
  Enclosure coupling, coupling_across;
  Enclosure shear_compliance, shear_compliance_across;
  Enclosure in_line, across;
  std::optional<Decay> decay = {};  ///< if asked for; proven error of a part: 10^-digits of the largest
};

/// The response along lines of the direction `psi` to loads that move at `speed`, unit sqrt(modulus/density), in the
/// direction `motion` at the angle theta. The phase speed along the lines, speed cos(psi - theta), has either sign.
///
/// All error bounds are proven (interval arithmetic, see impedance.hpp). The compliance has the relative accuracy of an
/// Enclosure. The error bounds of the other components, some of which are exactly 0 for symmetric solids, are at most
/// 10^-digits max(compliance, in_line, across). Beyond the surface wave's speed the compliance is negative; the results
/// are still the solution of the equations that decays with depth.
///
/// BadInput "speed" unless speed |cos(psi - theta)| is below the limiting speed of psi by at least about 1e-16 of
/// itself; "digits" unless 16 <= digits <= 1000. (brock2012 18a, brock2013 14, 25b, 43a)
LineResponse line_response(const ExactStiffness& solid, const Exact& speed, const SurfaceDirection& motion,
                           const SurfaceDirection& psi, int digits, bool with_decay = false);

/// The components of the response that contacts need, from line_response() or from elsewhere.
struct LineAnswer {
  Float compliance, coupling, coupling_across, in_line;
  Float shear_compliance = zero_of_bits(64), shear_compliance_across = zero_of_bits(64);
  std::optional<Decay> decay = {};  ///< needed only for displacements below the surface
};

/// The response along lines at an angle from the motion in degrees, with relative error 10^-digits.
using SurfaceAnswer = std::function<LineAnswer(const Exact& degrees, int digits)>;

}  // namespace nipref::ref
