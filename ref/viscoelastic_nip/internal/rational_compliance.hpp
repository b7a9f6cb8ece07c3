#pragma once
#include <vector>

#include <nipref/ref/material/internal/polynomial.hpp>

namespace nipref::ref {

/// Re amplitude e^(-rate t)
struct ComplianceTerm {
  ComplexFloat amplitude;  ///< 1/(stress time); of two conjugate terms their sum's, twice that of one
  ComplexFloat rate;       ///< 1/time; imaginary part >= 0; exactly 0 if the denominator has no p^0
};

/// theta(t) = at_once delta(t) + sum of the terms
struct Compliance {
  Float at_once;  ///< 1/stress
  std::vector<ComplianceTerm> terms;
};

/// The function whose transform is numerator/denominator, to the working precision; the numerator is of the
/// denominator's degree or, for a function that is 0 at once, below it. Common factors
/// are cancelled, exactly. The denominator's zeros are found by Aberth's method with twice the digits: one is
/// within n |p/p'| of each that is found, p of degree n; BadInput, naming "nip.material", unless that is below
/// rounding.
Compliance rational_compliance(Polynomial numerator, Polynomial denominator);

}  // namespace nipref::ref
