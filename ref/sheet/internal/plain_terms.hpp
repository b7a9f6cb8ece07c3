#pragma once
#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/sheet/internal/residues.hpp>
#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {

/// A kernel's coefficient at a root, twice its residue.
ComplexInterval plain_coefficient(PlainKernel kernel, const SheetPole& pole);

inline bool is_odd(PlainKernel kernel) {
  return kernel == PlainKernel::I3 || kernel == PlainKernel::I4 || kernel == PlainKernel::I5;
}

/// BadInput unless 1 <= terms <= most_residue_terms.
void check_residue_terms(int terms);

/// Whether the terms from the n-th on, without pi, sum to less than 2^-precision at x >= 0; if so, `bound` is set to a
/// bound of the sum. There are at most 500 terms, Im z_n > (n - 1/2) pi, and no coefficient exceeds 2.1, see
/// residue_series().
bool is_negligible(int n, const Interval& x, mpfr_prec_t precision, Interval& bound);

}  // namespace nipref::ref
