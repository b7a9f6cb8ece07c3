#pragma once
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

// Kernels as the thesis sums them, to any accuracy: the sum of the first `terms` residues. The intervals enclose this
// sum; its truncation error is not included.

inline constexpr int most_residue_terms = 500;

/// I6 is the sum of its two parts, of which I6_alpha_part includes I1.
enum class PlainKernel { I1, I3, I4, I5, I6_alpha_part, I6_eta_part, I7 };

/// The n-th term of a kernel over pi is e^(-K x) (A sin m x + B cos m x) at x >= 0, with the root m + i K.
struct ResidueCoefficients {
  Enclosure A, B;
};

/// The coefficients for 1 <= n <= 10^9, digits 16 to 1000, otherwise BadInput. Proven. (thesis AI.8, AI.13, AI.14)
ResidueCoefficients residue_coefficients(PlainKernel kernel, int n, int digits);

/// An interval that contains the sum for I1, I3 or I6_alpha_part at every point of the interval `alpha`, which does not
/// contain 0. It has the precision of `alpha`. BadInput unless 1 <= terms <= 500. (thesis AI.9, AI.12)
Interval plain_series(PlainKernel kernel, const Interval& alpha, int terms);

}  // namespace nipref::ref
