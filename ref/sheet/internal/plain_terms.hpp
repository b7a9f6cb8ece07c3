#pragma once
#include <memory>

#include <nipref/ref/number/internal/complex_interval.hpp>
#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {

/// The n-th root z and the kernels' coefficients there, twice those of residue_series().
struct PlainTerm {
  ComplexInterval z, I1, I3, I4, I5, I6;

  [[nodiscard]] const ComplexInterval& coefficient(PlainKernel kernel) const;
};

/// Kept.
std::shared_ptr<const PlainTerm> plain_term(int n, mpfr_prec_t precision);

ComplexInterval reciprocal(const ComplexInterval& x);

inline bool is_odd(PlainKernel kernel) {
  return kernel != PlainKernel::I1 && kernel != PlainKernel::I6_alpha_part;
}

/// BadInput unless 1 <= terms <= most_residue_terms.
void check_residue_terms(int terms);

/// Of all the terms from the n-th on, pi left out, at x >= 0: there are at most 500, Im z_n > (n - 1/2) pi, and no
/// coefficient is larger than 2.1, see residue_series(). Nothing where that is not below 2^-precision.
bool is_negligible(int n, const Interval& x, mpfr_prec_t precision, Interval& bound);

}  // namespace nipref::ref
