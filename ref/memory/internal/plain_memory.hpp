#pragma once
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {

// Of a kernel's first `terms` residues, not of I6, within intervals of some e^{-nats}. What the roots make of a distance
// and of a rate is kept, as the loads of a contact share them.

/// plain_series() at a point, alpha != 0.
Interval plain_kernel_at(PlainKernel kernel, const Exact& alpha, int terms, double nats);

/// int_alpha^inf e^{-rate (w - alpha)} I(w) dw, rate > 0: what steady_memory() is of the kernel. The after-contact
/// sum, whose rest falls only like 0.2/terms, is among it, as in the thesis. (thesis 6.25-6.28)
Interval plain_memory(PlainKernel kernel, const Exact& alpha, const Exact& rate, int terms, double nats);

}  // namespace nipref::ref
