#pragma once
#include <vector>

#include <nipref/ref/material/internal/polynomial.hpp>
#include <nipref/ref/number/internal/complex.hpp>

namespace nipref::ref {

/// A term amplitude/(p + rate) of the transform, amplitude e^(-rate t) in time.
struct OscillatingTerm {
  ComplexInterval amplitude, rate;
};

/// The terms whose sum is numerator/denominator, one for each root, also for both of a conjugate pair. The
/// denominator has the higher degree and only simple roots. Proven: ref/README.md, Lemma 11.
/// Bits are added until no discs overlap.
std::vector<OscillatingTerm> partial_fractions(const Polynomial& numerator, const Polynomial& denominator,
                                               mpfr_prec_t bits);

/// Whether some root is also a root of the derivative.
bool has_repeated_root(const Polynomial& denominator);

}  // namespace nipref::ref
