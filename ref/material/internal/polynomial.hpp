#pragma once
#include <functional>
#include <optional>
#include <vector>

#include <nipref/ref/material/rational_solid.hpp>
#include <nipref/ref/number/internal/complex.hpp>

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

}  // namespace nipref::ref
