#pragma once
#include <gmpxx.h>

#include <vector>

#include <nipref/ref/number/internal/complex_float.hpp>
#include <nipref/ref/number/internal/complex_interval.hpp>

namespace nipref::ref {

/// With rational coefficients, that of p^0 first.
using Polynomial = std::vector<mpq_class>;

Polynomial product(const Polynomial& a, const Polynomial& b);
Polynomial sum(const Polynomial& a, const Polynomial& b);
/// Without the zeros at its end.
Polynomial trimmed(Polynomial p);
/// The quotient, and the remainder in place of the dividend; the divisor's last coefficient is not 0.
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

/// Approximations of all zeros at once by the method of Ehrlich and Aberth: until none moves by more than `unit` of
/// itself, or their polynomial is lost in its rounding. To be proven by whoever uses them.
std::vector<ComplexFloat> approximate_zeros(const FloatPolynomial& p, const Float& unit);

/// Points near the roots, 0 as often as it is one, to about so many bits; to be proven likewise.
std::vector<ComplexInterval> roots_near(Polynomial p, mpfr_prec_t bits);

}  // namespace nipref::ref
