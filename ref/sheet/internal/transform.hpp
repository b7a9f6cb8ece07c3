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
/// by the trapezoidal rule. ref/sheet/README.md, Kernels, bounds its aliasing, truncation and rounding errors. The
/// value for an even symbol is about e^{-2.1 x}, so that a relative accuracy requires digits and nodes in proportion to
/// x. For large x residue_series() is used instead.
Interval transform(Symbol symbol, const Exact& x, double nats);

}  // namespace nipref::ref
