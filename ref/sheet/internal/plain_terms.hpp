#pragma once
#include <array>
#include <memory>

#include <nipref/ref/number/internal/complex_interval.hpp>
#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {

/// The n-th root z, and the kernels' coefficients at it in the order of PlainKernel, twice their residues.
struct PlainTerm {
  ComplexInterval z;
  std::array<ComplexInterval, 7> coefficients;

  [[nodiscard]] const ComplexInterval& coefficient(PlainKernel kernel) const {
    return coefficients[static_cast<std::size_t>(kernel)];
  }
};

/// The n-th term, cached.
std::shared_ptr<const PlainTerm> plain_term(int n, mpfr_prec_t precision);

ComplexInterval reciprocal(const ComplexInterval& x);

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
