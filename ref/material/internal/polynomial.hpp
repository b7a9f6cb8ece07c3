#pragma once
#include <gmpxx.h>

#include <vector>

#include <nipref/ref/number/internal/complex_float.hpp>
#include <nipref/ref/number/internal/complex_interval.hpp>

namespace nipref::ref {

/// A polynomial with rational coefficients; the first is that of p^0.
using Polynomial = std::vector<mpq_class>;

Polynomial product(const Polynomial& a, const Polynomial& b);
Polynomial sum(const Polynomial& a, const Polynomial& b);
/// The polynomial without zero coefficients at its end.
Polynomial trimmed(Polynomial p);
/// Returns the quotient and replaces the dividend by the remainder; the divisor's last coefficient is not 0.
Polynomial divide(Polynomial& dividend, const Polynomial& divisor);
/// Divides both by their greatest common factor; the denominator is not 0.
void cancel(Polynomial& numerator, Polynomial& denominator);

/// Aberth's and Ehrlich's correction of one of the approximate zeros of a function: Newton's for the function over the product
/// of its distances from the others. `slope_over_value` is that of the function at the zero.
ComplexFloat zero_correction(const std::vector<ComplexFloat>& zeros, std::size_t number,
                             const ComplexFloat& slope_over_value);

/// Approximations of the roots to about `bits` bits. A root 0 is exact and appears as often as its multiplicity. The
/// caller has to prove the others.
std::vector<ComplexInterval> roots_near(Polynomial p, mpfr_prec_t bits);

}  // namespace nipref::ref
