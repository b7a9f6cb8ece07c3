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
/// Divides both polynomials by their greatest common factor; the denominator is not 0.
void cancel(Polynomial& numerator, Polynomial& denominator);

/// log2 of a bound of the roots' magnitudes, to 1e-10; -infinity if all roots are 0. (Fujiwara)
double log2_root_bound(const Polynomial& p);

/// Approximations of all zeros of a function f by the method of Ehrlich and Aberth, from initial guesses `zeros`, which
/// all differ: Newton's method for f over the product of the differences from the other zeros, until no zero changes by
/// more than `unit` times its magnitude. slope_over_value(z) is f'(z)/f(z), or nothing where f(z) counts as 0.
std::vector<ComplexFloat> zeros_by_steps(
    std::vector<ComplexFloat> zeros,
    const std::function<std::optional<ComplexFloat>(const ComplexFloat& z)>& slope_over_value,
    const Float& unit);

/// Approximations of the roots to about `bits` bits, as intervals of width 0. A root 0 is exact and appears as often as
/// its multiplicity. The other roots are not proven.
std::vector<ComplexInterval> roots_near(Polynomial p, mpfr_prec_t bits);

/// A term amplitude e^(-rate t), whose transform is amplitude/(p + rate).
struct OscillatingTerm {
  ComplexInterval amplitude, rate;
};

/// The terms whose sum is numerator/denominator, one for each root of the denominator, also for each of a conjugate
/// pair. The denominator has the higher degree and only simple roots. Proven: ref/README.md, Lemma 11. The precision is
/// raised until the discs that contain the roots do not overlap.
std::vector<OscillatingTerm> partial_fractions(const Polynomial& numerator, const Polynomial& denominator,
                                               mpfr_prec_t bits);

/// Whether some root is also a root of the derivative.
bool has_repeated_root(const Polynomial& denominator);

/// The function of time whose transform is numerator/denominator, at t > 0. The denominator has a higher degree than
/// the numerator, which is not 0. It is proven that the interval contains the value; it becomes narrower with more
/// bits. Proof: ref/material/README.md, Inverse transforms.
Interval inverse_transform(const Polynomial& numerator, const Polynomial& denominator, const mpq_class& t,
                           mpfr_prec_t bits);

/// The slowest rate, -max Re z over the roots z of the denominator. The roots are approximations, not proven.
double slowest_rate(const Polynomial& denominator);

}  // namespace nipref::ref
