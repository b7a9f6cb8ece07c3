#pragma once
#include <nipref/ref/material/rational_solid.hpp>
#include <nipref/ref/number/enclosure.hpp>

namespace nipref::ref {

// theta = gamma_0 + sum gamma_r/(p + lambda_r) as a function of p: the terms in the order of Re lambda_r, of a conjugate
// pair that with Im lambda_r < 0 first. (thesis 6.16, 6.17, AIII.5-AIII.8)

/// gamma of the term of that number, 0 for what answers at once; digits 16 to 1000. Proven. BadInput for a number of no
/// term, a theta that answers an impulse by more than an impulse, repeated rates, and for two terms that are no pair with
/// rates whose real parts agree to 1e-12: their order could be either.
Enclosure relaxation_amplitude(const ExactRatio& theta, int number, ComplexPart part, int digits);
/// lambda, number >= 1.
Enclosure relaxation_rate(const ExactRatio& theta, int number, ComplexPart part, int digits);

}  // namespace nipref::ref
