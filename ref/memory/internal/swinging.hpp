#pragma once
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/internal/complex_interval.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>

namespace nipref::ref {

/// steady_memory() of fading.hpp for a rate L that may be complex, Re L > 0, known within an interval; |alpha| <= 1000.
/// Good to e^{-nats} beside what the interval makes. Proven.
///
/// With A = |alpha|, c = 1/2 for I1 and 1/(2i) for odd kernels, and the integral
///
///     U(A, m) = c int G(z) e^{i z A}/(m - i z) dz    along z(t) = sinh(t + i phi)
///
/// it is, as fading.hpp has it for real rates and whatever lies between the path and 0,
///
///     alpha >= 0    U(A, L)               + pi/(4 L) for odd kernels
///     alpha < 0     +-U(A, -L) + P        - pi/(4 L) for odd kernels; - for I1
///
/// for I(-w) = +-I(w) and the whole line's integral, continued from small rates, is P = pi G(i L) e^{-L A}, of odd
/// kernels times i. U(A, -L) is continued from rates of positive real part, on which way its pole i L comes from below:
/// P is left out where the pole lies above the path, whose residue it then cancels.
///
/// The trapezoidal rule of step h runs in the strip phi +- 3/16, which is within that of contour_memory(), so that no
/// root of S is near and, the means of |F| over lines being convex in their logarithm (Hardy), int |G z'/z| dt <= 30 along
/// each of its edges. Of phi = 1/4 and 3/4 that one is taken whose strip is 1/16 or more away from the pole z_p =
/// sinh(s + i psi): phi = 1/4 for psi >= 1/2. There |z|/|m - i z| = |z|/|z - z_p| <= 104, for
///
///     |sinh a - sinh b| = 2 |cosh((a + b)/2) sinh((a - b)/2)|,   |cosh(x + iy)|^2 = sinh^2 x + cos^2 y,
///     |sinh(x + iy)|^2 = sinh^2 x + sin^2 y,   |sinh a| <= 2 cosh Re((a + b)/2) cosh Re((a - b)/2),
///
/// cos y >= 0.31 and |sin y| >= 1/32.01; and for -i L, below the axis, it is at most 1/sin(1/16). For Re z >= 2, where |1 -
/// E^4 + 4 z E^2| > 0.78, |G z'/z| <= 6 e^{-k t - r Re z}, k = 1, r = 0 for I1, k = 0 and r = SymbolBounds::decay
/// for the others. So
///
///     aliasing      104 * 30/(e^{2 pi (3/16)/h} - 1);   2 pi (3/16)/h >= nats + 10
///     truncation    with q(t) = k t + r Re z + A Im z, q' >= 0.7, both ways: below 104 * 6/0.7 e^{-q(J h)};
///                   q(J h) >= nats + 9, Re z(J h) >= 2
///
/// are below e^{-nats}/2. All else is in interval arithmetic.
ComplexInterval swinging_memory(Symbol kernel, const Exact& alpha, const ComplexInterval& rate, double nats);

}  // namespace nipref::ref
