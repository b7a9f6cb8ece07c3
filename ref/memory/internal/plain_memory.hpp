#pragma once
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {

// The memory of the sum of a kernel's first `terms` residues (all kernels but I6), as intervals of half-width about
// e^{-nats}. The roots' functions of a distance and of a rate are cached, as the loads of a contact share them.

/// plain_series() at a point, alpha != 0.
Interval plain_kernel_at(PlainKernel kernel, const Exact& alpha, int terms, double nats);

/// int_alpha^inf e^{-rate (w - alpha)} I(w) dw, rate > 0, for the sum I; steady_memory() is the same for the kernel.
/// As in the thesis it includes the sum after the contact, whose truncation error decreases only like 0.2/terms.
/// (thesis 6.25-6.28)
Interval plain_memory(PlainKernel kernel, const Exact& alpha, const Exact& rate, int terms, double nats);

}  // namespace nipref::ref
