#pragma once
#include <array>

#include <nipref/fast/memory/internal/gauss_rules.hpp>
#include <nipref/fast/memory/internal/waves.hpp>
#include <nipref/fast/number/accuracy.hpp>

namespace nipref::fast::internal {

/// Where the memory under the load is cut.
inline constexpr std::array core_stops{-inner_end, 0.0, inner_end, 1.0};
/// The memory of the whole pieces that end there, each from its own start.
using CorePieces = std::array<double, core_stops.size()>;

CorePieces core_pieces(Kernel kernel, double rate, Accuracy accuracy);

/// int_0^length e^(-rate d) I(w + d) dd for -1 <= w < end = w + length <= 1, I the whole kernel: exponential
/// integrals for the logarithm, Gauss rules for what is smooth. Both end and length, as either may be too
/// small to be seen in the rounding of the other. `whole`: of the same kernel and rate.
double memory_under_load(Kernel kernel, double w, double end, double length, double rate,
                         const CorePieces& whole, Accuracy accuracy);
/// The same for a complex rate by panels, finer towards the logarithm.
Complex memory_under_load(Kernel kernel, double w, double end, double length, Complex rate,
                          Accuracy accuracy);

}  // namespace nipref::fast::internal
