#pragma once
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>

namespace nipref::ref {

/// int_alpha^inf e^{-rate (w - alpha)} I(w) dw, rate > 0, the memory of a load that has come from infinity, as an
/// interval of half-width about e^{-nats}. I is I1 (for `normal`), I3, I4 or I5. Proven.
///
/// Let G be the whole symbol of the kernel (for I1 2 sinh^2 z/(z S)), which is real on the real axis. The memory of the
/// wave e^{i z w} is e^{i z alpha}/(rate - i z), so that the integral is, for either sign of alpha and along any line
/// Im z = s, 0 < s < 2,
///
///     I1           (1/2) int G(z) e^{i z alpha}/(rate - i z) dz
///     I3, I4, I5   1/(2i) times the same integral, plus pi/(4 rate) for half the symbol's pole 1/(2z) at 0.
///
/// The line is above 0 and above the pole at -i rate, and below the roots z_n of S. For -1 < alpha < 1 it is
/// deformed, see contour_memory(); otherwise it is closed around the poles. With A = |alpha| (residues.hpp)
///
///     alpha >= 1    fading_residue_series()                                  (odd kernels: + pi/(4 rate))
///     alpha <= -1   fading_residue_series() + pi G(i rate) e^{-rate A}, the residue at -i rate
///                                                (odd: i pi G(i rate) instead of pi G(i rate), - pi/(4 rate))
///
/// At rate 0 the function is the limit; for odd kernels, pi/(4 rate) + pi/4 alpha is subtracted before. Expanding the
/// residues at 0 and at -i rate gives: the roots' series - pi/4 A for A >= 1; the contour's integral - pi/4 alpha for
/// A < 1; and for I1, whose G is finite at 0, pi/2 where the residue at -i rate contributes.
Interval steady_memory(Symbol kernel, const Exact& alpha, const Exact& rate, double nats);

/// The same for -1 <= alpha <= 1 by the trapezoidal rule of step h in t on the path
///
///     z(t) = sinh(t + i/2), alpha >= 0,      z(t) = 3i/2 + sinh(t - i/2), alpha < 0,
///
/// on which the integrand F decays double exponentially because of the wave or the symbol, and for I1 at least like
/// e^{-t} because of 1/z. F(-t) is the conjugate of F(t), so that half the nodes suffice: the integral is h (F(0)/2 +
/// sum_{j>=1} F(j h)), of which I1 takes the real part and the other kernels the imaginary part.
///
/// The error is below e^{-nats} for every rate. For |Im t| <= 7/16 the paths are hyperbolas of the same kind with
/// angles 1/16 to 15/16. They stay above 0 and -i rate and do not meet a root of S, so that F is analytic, and
/// 1/|rate - i z| <= v with v = 1/|z| where Im z >= 0 and v = 1/|Re z| elsewhere. Let E be e^{max(0, Im z)} on the
/// second path and 1 on the first; then |e^{i z alpha}| <= E. On an interval mesh tests/ref/memory/fading.cpp proves
/// that S has no roots in the strip and that
///
///     along both edges together    int |G z' v E| dt <= 30
///     on the path itself           |G z' v| <= 5 e^{-k t - r Re z}, t >= 0
///
/// with k = 1, r = 0 for I1, k = 0 and r = SymbolBounds::decay for the others. The parts of the error are
///
///     aliasing      15/(e^{2 pi (7/16)/h} - 1): half the edges' integrals (Poisson summation);
///                   2 pi (7/16)/h >= nats + 5
///     truncation    with q(t) = k t + r Re z + A Im z (first path) or - A Im z (second), A = |alpha|, the
///                   integrand is below 5 e^{-q}, and q' >= min(1, cos(1/2)) increases: the integral beyond J h is
///                   below 6 e^{-q(J h)};  q(J h) >= nats + 4
///     rounding      55 h (J+1) (J+65) 2^-p, see term_error in fading.cpp; p is chosen to make this e^{-nats}/4.
Interval contour_memory(Symbol kernel, const Exact& alpha, const Exact& rate, double nats);

}  // namespace nipref::ref
