#pragma once
#include <nipref/ref/material/internal/polynomial.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// The function of time whose transform is numerator/denominator, at t > 0, where impulses at 0 do not matter. The
/// denominator has a higher degree than the numerator, which is not 0. The interval contains the value, proven, and
/// becomes narrower with more bits. Proof: ref/material/README.md, Inverse transforms.
Interval inverse_transform(const Polynomial& numerator, const Polynomial& denominator, const mpq_class& t,
                           mpfr_prec_t bits);

/// An upper bound of the slowest rate, -max Re of the roots of D, by which values that underflow are refused.
double slowest_rate(const Polynomial& denominator);

}  // namespace nipref::ref
