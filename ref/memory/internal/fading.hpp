#pragma once
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>

namespace nipref::ref {

/// int_alpha^inf e^{-rate (w - alpha)} I(w) dw, rate > 0, within an interval of half-width about e^{-nats}:
/// what a sheet remembers of a load that has come from infinity. I is I1 (for `normal`), I3, I4 or I5. Proven.
///
/// With G the whole symbol of the kernel (for I1 2 sinh^2 z/(z S)), which is real on the real axis, the wave
/// e^{i z w} leaves e^{i z alpha}/(rate - i z), and the integral is, for either sign of alpha and along any
/// line Im z = s, 0 < s < 2,
///
///     I1           (1/2) int G(z) e^{i z alpha}/(rate - i z) dz
///     I3, I4, I5   (1/(2i)) of the same, plus pi/(4 rate) of half the symbol's pole 1/(2z) at 0.
///
/// The line lies above 0 and the pole at -i rate and below the roots z_n of S. For -1 < alpha < 1 it is bent,
/// see contour_memory(), for all others closed around the poles: with A = |alpha| (residues.hpp)
///
///     alpha >= 1    fading_residue_series()                                  (odd kernels: + pi/(4 rate))
///     alpha <= -1   fading_residue_series() + pi G(i rate) e^{-rate A}, what -i rate gives
///                                                (odd: i pi G(i rate) instead of pi G(i rate), - pi/(4 rate))
///
/// At rate 0 it is the limit, for odd kernels less pi/(4 rate) + pi/4 alpha: with what the pole at 0 and -i rate give
/// expanded, roots - pi/4 A beyond 1, the contour's integral - pi/4 alpha within it, and for I1 pi/2 where
/// -i rate gives something. G is finite at 0 for I1, and the line lies above 0.
Interval steady_memory(Symbol kernel, const Exact& alpha, const Exact& rate, double nats);

/// The same for -1 <= alpha <= 1 by the trapezoidal rule of step h in t on the path
///
///     z(t) = sinh(t + i/2), alpha >= 0,      z(t) = 3i/2 + sinh(t - i/2), alpha < 0,
///
/// on which the wave, I1's 1/z or the symbol, makes the integrand F die away double exponentially (that of I1
/// like e^{-t} at least). As F(-t) is the conjugate of F(t), half the nodes do: the integral is h (F(0)/2 +
/// sum_{j>=1} F(j h)), its real part for I1, its imaginary part for the others.
///
/// The error is below e^{-nats}, for every rate. In the strip |Im t| <= 7/16 the paths are such hyperbolas of
/// angles 1/16 to 15/16. They stay above 0 and -i rate and meet no root of S, so that F is analytic, and
/// 1/|rate - i z| <= v with v = 1/|z| where Im z >= 0 and v = 1/|Re z| elsewhere. Let E be e^{max(0, Im z)} on
/// the second path and 1 on the first; |e^{i z alpha}| <= E. On an interval mesh
/// tests/ref/memory/fading.cpp proves that there are no roots of S in the strip and that
///
///     along both edges together    int |G z' v E| dt <= 30
///     on the path itself           |G z' v| <= 5 e^{-k t - r Re z}, t >= 0
///
/// with k = 1, r = 0 for I1, k = 0 and r = SymbolBounds::decay for the others. The parts of the error are
///
///     aliasing      15/(e^{2 pi (7/16)/h} - 1): half the edges' integrals (Poisson summation);
///                   2 pi (7/16)/h >= nats + 5
///     truncation    with q(t) = k t + r Re z + A Im z (first path) or - A Im z (second), A = |alpha|, the
///                   integrand is below 5 e^{-q}, q' >= min(1, cos(1/2)) rises: what is left out beyond J h is
///                   below 6 e^{-q(J h)};  q(J h) >= nats + 4
///     rounding      55 h (J+1) (J+65) 2^-p: see term_error in fading.cpp; p makes it e^{-nats}/4.
Interval contour_memory(Symbol kernel, const Exact& alpha, const Exact& rate, double nats);

}  // namespace nipref::ref
