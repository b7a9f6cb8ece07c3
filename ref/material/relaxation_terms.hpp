#pragma once
#include <nipref/ref/material/rational_solid.hpp>
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {

// The terms of theta = gamma_0 + sum gamma_r/(p + lambda_r), r = 1, 2, ..., as a function of p. They are in the order
// of Re lambda_r; in a conjugate pair, the term with Im lambda_r < 0 is first. (thesis 6.16, 6.17, AIII.5-AIII.8)

/// gamma_r, r = `number`; number 0 is the instantaneous compliance gamma_0. digits 16 to 1000. Proven. BadInput if
/// there is no such term, if the numerator of theta has a higher degree than the denominator, if rates are repeated,
/// and if the real parts of two rates that are no pair agree to 1e-12 of them, so that their order is not certain.
Enclosure relaxation_amplitude(const ExactRatio& theta, int number, ComplexPart part, int digits);
/// lambda_r, r = `number` >= 1.
Enclosure relaxation_rate(const ExactRatio& theta, int number, ComplexPart part, int digits);

}  // namespace nipref::ref
