#pragma once
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>

namespace nipref::ref {

/// int_alpha^inf e^{-rate (w - alpha)} I(w) dw, rate > 0, the memory of a load that has come from infinity, as an
/// interval of half-width about e^{-nats}. I is I1 (for `normal`), I3, I4 or I5. Proven.
///
/// Along the real axis by contour_memory() for -1 < alpha < 1, otherwise by fading_residue_series() and the pole at i
/// rate. At rate 0 it is the limit, for odd kernels after pi/(4 rate) + pi/4 alpha is subtracted: see
/// ref/memory/README.md, The memory of a load from infinity.
Interval steady_memory(Symbol kernel, const Exact& alpha, const Exact& rate, double nats);

/// The same for -1 <= alpha <= 1 by the trapezoidal rule of step h in t on the path
///
///     z(t) = sinh(t + i/2), alpha >= 0,      z(t) = 3i/2 + sinh(t - i/2), alpha < 0,
///
/// with half the nodes, h (F(0)/2 + sum_{j>=1} F(j h)), as F(-t) is the conjugate of F(t). The error is below e^{-nats}
/// for every rate, being the sum of
///
///     aliasing      15/(e^{2 pi (7/16)/h} - 1);   2 pi (7/16)/h >= nats + 5
///     truncation    6 e^{-q(J h)}, q(t) = k t + r Re z + A Im z (first path) or - A Im z (second), A = |alpha|, k = 1
///                   and r = 0 for I1, k = 0 and r = SymbolBounds::decay for the others;   q(J h) >= nats + 4
///     rounding      contour_term h (J+1) (J+1+contour_rounding) 2^-p; p is chosen to make this e^{-nats}/4
///
/// Proof: the same page.
Interval contour_memory(Symbol kernel, const Exact& alpha, const Exact& rate, double nats);
inline constexpr double contour_term = 55;      ///< bounds (1 + |alpha z|) |F|
inline constexpr double contour_rounding = 64;  ///< units 2^-p of that, of the error of a term

}  // namespace nipref::ref
