#pragma once
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// Influence functions of the elastic sheet: displacements of its surface in plane strain under a pair of
/// opposite unit line loads, one on each face, to any accuracy.
///
/// alpha = y/b is the distance from the load, eta = l/b the distance of the fixed point of the centre line from the
/// load, b the half thickness. Both are dimensionless, |.| <= 1000. young > 0 is in any unit of stress, -1 < poisson <=
/// 1/2; results are in units of 1/young per unit line load. theta1 = (1 + poisson)/young, theta2 = (1 + poisson)(1 - 2
/// poisson)/young, N = theta1 + theta2. Promise and errors as in kernels.hpp.

/// [theta2 I4(eta) - theta1 I5(eta)]/(pi N), an odd function of eta. (thesis 4.24, with the sign of eta outside)
Enclosure F1(const Exact& eta, const Exact& poisson, int digits);

/// |eta|/4 - (1/pi) I6_eta(eta) + theta1 I7(eta)/(pi N), the part of vs/N that depends on eta. I6_eta is the transform
/// of 2 cosh z/(z S), see internal/intervals.hpp. (thesis 4.24)
Enclosure F2(const Exact& eta, const Exact& poisson, int digits);

/// Normal displacement under the normal load, N I1(alpha)/pi; alpha != 0. (thesis 4.8, 4.25a)
Enclosure un(const Exact& alpha, const Exact& young, const Exact& poisson, int digits);

/// Tangential displacement under the normal load, [N I3(alpha) - theta2 I2(alpha)]/pi + N F1(eta).
/// (thesis 4.8, 4.25c; the printed (4.8) lacks a factor 1/pi at I4 + I5)
Enclosure vn(const Exact& alpha, const Exact& eta, const Exact& young, const Exact& poisson, int digits);

/// Normal displacement under the tangential load, [theta2 I2(alpha) - N I3(alpha)]/pi. (thesis 4.19a, 4.25b)
Enclosure us(const Exact& alpha, const Exact& young, const Exact& poisson, int digits);

/// Tangential displacement under the tangential load, [N I6(alpha, eta) + theta1 I7(eta)]/pi; alpha != 0.
/// (thesis 4.19b, 4.25d)
Enclosure vs(const Exact& alpha, const Exact& eta, const Exact& young, const Exact& poisson, int digits);

}  // namespace nipref::ref
