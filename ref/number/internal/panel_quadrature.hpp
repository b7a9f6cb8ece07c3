#pragma once
#include <gmpxx.h>

#include <nipref/ref/number/internal/complex_interval.hpp>

namespace nipref::ref {

/// e^{-decay + i angle}, real numbers given exactly, to about `bits` bits however large they are.
ComplexInterval wave(const mpq_class& decay, const mpq_class& angle, mpfr_prec_t bits);

/// int_0^length e^{-(rate - i frequency) v} dv, a proven enclosure; rate, length >= 0.
///
/// By quadrature over 2^m panels of equal length d with |rate - i frequency| d <= 1/2: on each the integrand
/// is expanded in powers at the panel's start and integrated term by term, the remainder bounded. The panels'
/// integrals differ by the integrand at their starts alone, and these are added up by doubling,
///
///     sum_{p < 2^m} q^p = prod_{j < m} (1 + q^{2^j}),   q = e^{-(rate - i frequency) d},
///
/// so that neither many periods nor a rate near 0 cost anything.
ComplexInterval damped_wave_integral(const mpq_class& rate, const mpq_class& frequency,
                                     const mpq_class& length, mpfr_prec_t bits);

}  // namespace nipref::ref
