#pragma once
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>
#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {

/// int_alpha^inf e^{-L (w - alpha)} I(w) dw, the memory of a load that has come from infinity. I is I1, I3, I4
/// or I5; |alpha| <= 1000, alpha not 0 for I1. The rate L, Re L > 0, is given as an interval; the half-width is about
/// e^{-nats} plus the effect of that interval. At the rate 0, exactly, it is the limit, for odd kernels after
/// pi/(4 L) + pi/4 alpha is subtracted. Proven: ref/memory/README.md, The memory of a load from infinity.
///
/// For real rates and |alpha| >= 1 by the residues of the roots, otherwise by the trapezoidal rule along z = sinh(t + i phi)
/// within a strip phi +- d that is at least 1/16 from the pole of the memory.
ComplexInterval steady_memory(Symbol kernel, const Exact& alpha, const ComplexInterval& rate, double nats);
/// The same for a real rate, >= 0, with an interval that suffices.
Interval steady_memory(Symbol kernel, const Exact& alpha, const Exact& rate, double nats);

/// The interval of a real number by which others are divided and multiplied, for errors of about e^{-nats}.
ComplexInterval rate_interval(const Exact& rate, double nats);
/// Whether it is the number 0.
bool is_zero(const ComplexInterval& rate);

/// The angle phi and d of the strip; `pole` is the angle psi of the pole sinh(s + i psi), 0 or less below the axis.
struct MemoryStrip {
  double angle, half_width;
};
MemoryStrip strip_beside(double pole);

// The memory of the sum of a kernel's first `terms` residues (all kernels but I6), as intervals of half-width about
// e^{-nats}. The roots' functions of a distance and of a rate are cached, as the loads of a contact share them.

/// plain_series() at a point, alpha != 0.
Interval plain_kernel_at(PlainKernel kernel, const Exact& alpha, int terms, double nats);

/// int_alpha^inf e^{-rate (w - alpha)} I(w) dw, rate > 0, for the sum I; steady_memory() is the same for the kernel.
/// As in the thesis it includes the sum after the contact, whose truncation error decreases only like 0.2/terms.
/// (thesis 6.25-6.28)
Interval plain_memory(PlainKernel kernel, const Exact& alpha, const Exact& rate, int terms, double nats);

}  // namespace nipref::ref
