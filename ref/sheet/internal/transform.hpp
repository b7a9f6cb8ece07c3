#pragma once
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>

namespace nipref::ref {

/// The Fourier transform of a symbol at x = |x| given exactly, within an interval of half-width at most
/// e^{-nats}:
///
///     even, without pole at 0    int_0^inf G(t) cos(x t) dt
///     odd                        int_0^inf G(t) sin(x t) dt, half-width at most min(1, x) e^{-nats}
///     even, twofold pole at 0    (1/2) int_{Im z = s} G(z) e^{i x z} dz, any 0 < s < 2: the finite part of
///                                int_0^inf G(t) cos(x t) dt, plus pi x/4
///
/// by the trapezoidal rule with step h on a line Im z = s: T = e^{-x s} h sum' Re[G(j h + i s) e^{i x j h}].
/// Its error is the sum of
///
///     aliasing    (1/2) [M e^{-2x}/(e^{2 pi (2-s)/h} - 1) + M_b e^{-x y_b}/(e^{2 pi (s - y_b)/h} - 1)]
///                 (Poisson summation, each image moved to the edge Im z = 2 or y_b of the strip; y_b = -2,
///                 or 1/4 on a line above a twofold pole; M, M_b the integrals of |G| along the edges,
///                 SymbolBounds)
///                 odd, s = 0: min(M, x M') cosh(2x)/(e^{4 pi/h} - 1), as |sin w| <= min(1, |w|) cosh(Im w)
///     truncation  e^{-x s} 2^8 units of 2^-F (times min(1, theta (N+1)/(1-q)) for odd symbols), see Nodes
///     rounding    see wave_sum and sine_sum
///
/// On the real axis a pole at 0 adds to the sum what depends on x there: h x/4 for a simple one (half of
/// h G(t) sin(x t) at t = 0), -h x^2/8 for a twofold one (see Nodes).
///
/// A higher line needs fewer digits (the value itself is near e^{-2.1 x}, what is summed is e^{x s} times
/// that) but a smaller step; the cheapest of the allowed lines is taken.
Interval transform(Symbol symbol, const Exact& x, double nats);

}  // namespace nipref::ref
