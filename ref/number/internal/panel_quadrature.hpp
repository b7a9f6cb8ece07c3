#pragma once
#include <gmpxx.h>

#include <nipref/ref/number/internal/complex_interval.hpp>

namespace nipref::ref {

/// e^{-decay + i angle}, real numbers given exactly, to about `bits` bits however large they are.
ComplexInterval wave(const mpq_class& decay, const mpq_class& angle, mpfr_prec_t bits);

/// int_0^length e^{-(rate - i frequency) v} dv, a proven enclosure; rate, length >= 0.
///
/// Over 2^m panels, so that neither many periods nor a rate near 0 cost anything. Proof: ref/number/README.md, Waves
/// over panels.
ComplexInterval damped_wave_integral(const mpq_class& rate, const mpq_class& frequency,
                                     const mpq_class& length, mpfr_prec_t bits);

}  // namespace nipref::ref
