#pragma once
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

// Kernels as the thesis sums them, to any accuracy: the first `terms` residues as they stand. What is wrong with
// such a sum is not counted here; the intervals enclose the sum.

inline constexpr int most_residue_terms = 500;

/// I6 without the part that depends on eta alone.
enum class PlainKernel { I1, I3, I4, I5, I6_alpha_part };

/// The sum at every |alpha| of an interval without 0, `alpha` of one sign; its precision is the work's. BadInput
/// for terms beyond 1 to 500. (thesis AI.8, AI.9)
Interval plain_series(PlainKernel kernel, const Interval& alpha, int terms);

}  // namespace nipref::ref
