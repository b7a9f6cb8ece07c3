#pragma once
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/internal/complex_interval.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>

namespace nipref::ref {

/// steady_memory() of fading.hpp for a real or complex rate L, Re L > 0, which is given as an interval; |alpha| <=
/// 1000. The half-width is about e^{-nats} plus the effect of the rate's interval. Proven.
///
/// With A = |alpha|, c = 1/2 for I1 and 1/(2i) for odd kernels, and the integral
///
///     U(A, m) = c int G(z) e^{i z A}/(m - i z) dz    along z(t) = sinh(t + i phi)
///
/// it is, as in fading.hpp for real rates,
///
///     alpha >= 0    U(A, L)               + pi/(4 L) for odd kernels
///     alpha < 0     +-U(A, -L) + P        - pi/(4 L) for odd kernels; - for I1
///
/// since I(-w) = +-I(w), and since the integral over the whole line, continued analytically from small rates, is P =
/// pi G(i L) e^{-L A}, times i for odd kernels. U(A, -L) is continued from rates with a positive real part, for which
/// its pole i L is below the path. Where the pole is above the path, its residue would cancel P, and P is left out.
///
/// The trapezoidal rule with step h uses the strip phi +- 3/16. It is part of the strip of contour_memory(), so that
/// it contains no root of S; as the logarithms of the means of |F| along lines are convex (Hardy), int |G z'/z| dt <=
/// 30 along each of its edges. phi is 1/4 or 3/4, whichever strip is at least 1/16 from the pole z_p = sinh(s + i
/// psi): 1/4 for psi >= 1/2. There |z|/|m - i z| = |z|/|z - z_p| <= 104, because
///
///     |sinh a - sinh b| = 2 |cosh((a + b)/2) sinh((a - b)/2)|,   |cosh(x + iy)|^2 = sinh^2 x + cos^2 y,
///     |sinh(x + iy)|^2 = sinh^2 x + sin^2 y,   |sinh a| <= 2 cosh Re((a + b)/2) cosh Re((a - b)/2),
///
/// cos y >= 0.31 and |sin y| >= 1/32.01. For the pole -i L, below the axis, the quotient is at most 1/sin(1/16). For
/// Re z >= 2, where |1 - E^4 + 4 z E^2| > 0.78, |G z'/z| <= 6 e^{-k t - r Re z} with k = 1, r = 0 for I1, and k = 0,
/// r = SymbolBounds::decay for the others. Hence the errors
///
///     aliasing      104 * 30/(e^{2 pi (3/16)/h} - 1);   2 pi (3/16)/h >= nats + 10
///     truncation    with q(t) = k t + r Re z + A Im z, q' >= 0.7, at both ends: below 104 * 6/0.7 e^{-q(J h)};
///                   q(J h) >= nats + 9, Re z(J h) >= 2
///
/// are below e^{-nats}/2. Everything else is interval arithmetic.
ComplexInterval oscillating_memory(Symbol kernel, const Exact& alpha, const ComplexInterval& rate,
                                   double nats);

}  // namespace nipref::ref
