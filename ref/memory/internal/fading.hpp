#pragma once
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

enum class MemoryKernel { I1, I3, I4, I5 };

/// int_alpha^inf e^{-rate (w - alpha)} I(w) dw, rate > 0, |alpha| <= 1000, within an interval of half-width
/// e^{-nats}: what a sheet remembers of a load that has come from infinity.
///
/// With G(x) the symbol of the kernel (sheet/kernels.hpp) the integral is, for alpha >= 0 and alpha < 0,
///
///     Re, Im int_0^inf G(x) e^{i x alpha}/(rate - i x) dx,
///     +-int_0^inf G(x) e^{i x |alpha|}/(rate + i x) dx,
///
/// (Re and + for the even I1, Im and - for the odd ones). The path is turned to the ray arg z = 1/2, below
/// the symbol's poles, the first of them at arg z = 1.08; the symbol of an odd kernel has the pole 1/(2 z) at
/// 0, which adds its arc, 1/(4 rate). On the ray z = r e^{i/2} with ln r = s - e^{c - s} the integrand dies
/// away double exponentially at the lower end and, but for alpha = 0, at the upper one; c is so low that |z|
/// <= 1, rate and 1/|alpha| where the exponential rules, so that its strip of analyticity |Im s| < 0.45 is
/// that of the ray alone. The rule is the trapezoidal one in s.
///
/// The width is an estimate: e^{-2 pi 0.45/h} bounds the aliasing up to the integral of the modulus along the
/// edges of the strip, which is not bounded here but allowed e^10 max(1, 1/rate). Rounding and the ends cut
/// off are covered in the same way.
/// Measured at 600 random arguments (|alpha| from 1e-12 to 50 and 0, rate from 1e-8 to 1e8), the error was
/// below e^{-25} of the width.
Interval steady_memory(MemoryKernel kernel, const Exact& alpha, const Exact& rate, double nats);

}  // namespace nipref::ref
