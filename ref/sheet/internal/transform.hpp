#pragma once
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>

namespace nipref::ref {

/// The Fourier transform of a symbol at an exact x >= 0, as an interval of half-width at most e^{-nats}:
///
///     even, without pole at 0    int_0^inf G(t) cos(x t) dt
///     odd                        int_0^inf G(t) sin(x t) dt, half-width at most min(1, x) e^{-nats}
///     even, twofold pole at 0    (1/2) int G(z) e^{i x z} dz along any line Im z = s, 0 < s < 2: the finite
///                                part of int_0^inf G(t) cos(x t) dt, plus pi x/4
///
/// by the trapezoidal rule with step h: h sum' G(j h) cos(x j h), or with sin(x j h). Its error is the sum of
///
///     aliasing    M cosh(Y x)/(e^{2 pi Y/h} - 1), odd: min(M, x M' Y/2) times the same, Y = 2, below all poles. As
///                 many digits would require too small an h, there Y = 4 pi m, and passed_poles() is added to the sum
///     truncation  2^8 units of 2^-F (times min(1, theta (N+1)/(1-q)) for odd symbols), see Nodes
///     rounding    see cosine_sum and sine_sum
///
/// A pole at 0 adds to the sum what depends on x there: h x/4 for a simple one (half of h G(t) sin(x t) at
/// t = 0), -h x^2/8 for a twofold one (see Nodes). Proof: ref/sheet/README.md,
/// Kernels.
///
/// The value of an even symbol is about e^{-2.1 x}, so that a relative accuracy requires digits and nodes in
/// proportion to x. For large x residue_series() is used.
Interval transform(Symbol symbol, const Exact& x, double nats);

}  // namespace nipref::ref
