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

/// The same coefficients to the working precision.
struct FloatPolynomial {
  std::vector<Float> coefficients;

  explicit FloatPolynomial(const Polynomial& exact);
  [[nodiscard]] int degree() const { return static_cast<int>(coefficients.size()) - 1; }
  /// Value and slope.
  [[nodiscard]] std::pair<ComplexFloat, ComplexFloat> at(const ComplexFloat& z) const;
};

/// Approximations of all zeros by the method of Ehrlich and Aberth. It ends when no zero has a relative change above
/// `unit` or the polynomial's values are rounding errors. The caller has to prove the zeros.
std::vector<ComplexFloat> approximate_zeros(const FloatPolynomial& p, const Float& unit);

/// Approximations of the roots to about `bits` bits. A root 0 is exact and appears as often as its multiplicity. The
/// caller has to prove the others.
std::vector<ComplexInterval> roots_near(Polynomial p, mpfr_prec_t bits);

}  // namespace nipref::ref
