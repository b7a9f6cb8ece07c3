#pragma once
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

// Kernels as the thesis sums them, to any accuracy: the sum of the first `terms` residues. The intervals enclose this
// sum; its truncation error is not included.

inline constexpr int most_residue_terms = 500;

/// I6 without the part that depends on eta alone.
enum class PlainKernel { I1, I3, I4, I5, I6_alpha_part };

/// An interval that contains the sum at every |alpha| of an interval without 0, computed with the precision of `alpha`.
/// BadInput unless 1 <= terms <= 500. (thesis AI.8, AI.9)
Interval plain_series(PlainKernel kernel, const Interval& alpha, int terms);

}  // namespace nipref::ref
