#pragma once
#include <vector>

#include <nipref/ref/material/internal/polynomial.hpp>
#include <nipref/ref/number/internal/complex_interval.hpp>

namespace nipref::ref {

/// amplitude/(p + rate), or amplitude e^(-rate t).
struct SwingingTerm {
  ComplexInterval amplitude, rate;
};

/// The terms whose sum is numerator/denominator, of all roots, the two of a conjugate pair each; the denominator is of a
/// higher degree and has simple roots only. Proven: with points z_i near its n roots, the discs of radii n |D(z_i)|/|d
/// prod (z_i - z_j)| about them, d being D's last coefficient, hold the roots, each one if they are apart (Smith). Bits
/// are added until they are.
std::vector<SwingingTerm> partial_fractions(const Polynomial& numerator, const Polynomial& denominator,
                                            mpfr_prec_t bits);

/// Whether some root is a root of the derivative too.
bool has_repeated_root(const Polynomial& denominator);

}  // namespace nipref::ref
