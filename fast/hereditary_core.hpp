#pragma once
#include "fast/accuracy.hpp"
#include "fast/hereditary_waves.hpp"

namespace nipref::fast::internal {

/// int_0^length e^(-rate d) D(w + d) dd for -1 <= w < end = w + length <= 1, D the fading part of a kernel:
/// exponential integrals for the logarithm, Gauss rules for what is smooth. Both end and length, as either
/// may be too small to be seen in the rounding of the other. A complex rate by panels, finer towards the
/// logarithm.
template <typename Rate>
Rate memory_under_load(Kernel kernel, double w, double end, double length, Rate rate, Accuracy accuracy);

}  // namespace nipref::fast::internal
