#pragma once
#include <functional>
#include <optional>
#include <vector>

#include <nipref/ref/material/rational_solid.hpp>
#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// The coefficient of the highest power; p is not 0.
inline const mpq_class& last_of(const Polynomial& p) { return p.data().back(); }
/// Divides both by their greatest common factor; the denominator is not 0.
void cancel(Polynomial& numerator, Polynomial& denominator);

/// log2 of a bound of the roots' magnitudes, to 1e-10; -infinity if all roots are 0. (Fujiwara)
double log2_root_bound(const Polynomial& p);

/// Approximations of all zeros of a function, from different guesses, by the method of Ehrlich and Aberth: Newton's for the
/// function over the product of the distances from the others, until none changes by more than `unit` of itself. Nothing for
/// the slope over the value where the value is taken for 0.
std::vector<ComplexFloat> zeros_by_steps(
    std::vector<ComplexFloat> zeros,
    const std::function<std::optional<ComplexFloat>(const ComplexFloat& z)>& slope_over_value,
    const Float& unit);

/// Approximations of the roots to about `bits` bits. A root 0 is exact and appears as often as its multiplicity. The
/// caller has to prove the others.
std::vector<ComplexInterval> roots_near(Polynomial p, mpfr_prec_t bits);

/// A term amplitude/(p + rate) of the transform, amplitude e^(-rate t) in time.
struct OscillatingTerm {
  ComplexInterval amplitude, rate;
};

/// The terms whose sum is numerator/denominator, one for each root, also for both of a conjugate pair. The
/// denominator has the higher degree and only simple roots. Proven: ref/README.md, Lemma 11.
/// Bits are added until no discs overlap.
std::vector<OscillatingTerm> partial_fractions(const Polynomial& numerator, const Polynomial& denominator,
                                               mpfr_prec_t bits);

/// Whether some root is also a root of the derivative.
bool has_repeated_root(const Polynomial& denominator);

/// The function of time whose transform is numerator/denominator, at t > 0, where impulses at 0 do not matter. The
/// denominator has a higher degree than the numerator, which is not 0. The interval contains the value, proven, and
/// becomes narrower with more bits. Proof: ref/material/README.md, Inverse transforms.
Interval inverse_transform(const Polynomial& numerator, const Polynomial& denominator, const mpq_class& t,
                           mpfr_prec_t bits);

/// An upper bound of the slowest rate, -max Re of the roots of D, by which values that underflow are refused.
double slowest_rate(const Polynomial& denominator);

}  // namespace nipref::ref
