#pragma once
#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/nip/internal/tractions.hpp>

namespace nipref::fast {

/// I1/pi: the normal displacement that the pressure causes in an elastic sheet. `kernels` lives as long.
Tractions::SplitKernel frictionless_kernel(CountedKernels& kernels);

}  // namespace nipref::fast
