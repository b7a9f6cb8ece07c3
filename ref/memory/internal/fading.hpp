#pragma once
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>
#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {

/// int_alpha^inf e^{-L (w - alpha)} I(w) dw, the memory of a load that has come from infinity. I is I1, I3, I4 or I5;
/// |alpha| <= 1000, alpha != 0 for I1. The rate L is an interval, Re L > 0 or L = 0. The half-width of the result is
/// about e^{-nats} plus the effect of the interval L. At L = 0 the result is the limit, for odd kernels after pi/(4 L)
/// + pi/4 alpha is subtracted. Proven: ref/memory/README.md, The memory of a load from infinity.
///
/// For real rates and |alpha| >= 1 it is the sum of the residues at the roots. Otherwise it is computed by the
/// trapezoidal rule along z = sinh(t + i phi), in a strip phi +- d that is at least 1/16 from the pole of the memory.
ComplexInterval steady_memory(Symbol kernel, const Exact& alpha, const ComplexInterval& rate, double nats);
/// The memory for an exact real rate >= 0, as an interval of half-width about e^{-nats}.
Interval steady_memory(Symbol kernel, const Exact& alpha, const Exact& rate, double nats);

/// An interval for the rate that is narrow enough to multiply and divide by it with errors of about e^{-nats}.
ComplexInterval rate_interval(const Exact& rate, double nats);
/// Whether the rate is exactly 0.
bool is_zero(const ComplexInterval& rate);

/// The angle phi and half-width d of the strip. `pole` is psi of the pole sinh(s + i psi); it is <= 0 below the axis.
struct MemoryStrip {
  double angle, half_width;
};
MemoryStrip strip_beside(double pole);

// The sum of a kernel's first `terms` residues (all kernels but I6) and its memory, as intervals of half-width about
// e^{-nats}. The factors that depend on a distance or on a rate are cached, because the loads of a contact share them.

/// plain_series() at a point, alpha != 0.
Interval plain_kernel_at(PlainKernel kernel, const Exact& alpha, int terms, double nats);

/// int_alpha^inf e^{-rate (w - alpha)} I(w) dw, rate > 0, for the sum I; steady_memory() is the same for the kernel.
/// Behind the load it includes, as in the thesis, the sums at alpha = 0, whose truncation error decreases only like
/// 0.2/terms. (thesis 6.25-6.28)
Interval plain_memory(PlainKernel kernel, const Exact& alpha, const Exact& rate, int terms, double nats);

}  // namespace nipref::ref
