#pragma once
#include <vector>

#include <nipref/ref/material/internal/polynomial.hpp>

namespace nipref::ref {

/// The term Re amplitude e^(-rate t).
struct ComplianceTerm {
  ComplexFloat amplitude;  ///< 1/(stress time); for a conjugate pair twice that of one term
  ComplexFloat rate;       ///< 1/time; imaginary part >= 0; exactly 0 if the denominator has no p^0
};

/// theta(t) = at_once delta(t) + sum of the terms
struct Compliance {
  Float at_once;  ///< 1/stress
  std::vector<ComplianceTerm> terms;
};

/// The function whose transform is numerator/denominator, to the working precision. Common factors are cancelled
/// exactly. The denominator's zeros are found by Aberth's method with twice the digits; for p of degree n there is a
/// zero within n |p/p'| of each approximation. Throws data::NoMaterial that names `name` unless this distance is
/// below rounding and the numerator's degree is that of the denominator or, for a function without instantaneous
/// part, one less.
Compliance rational_compliance(Polynomial numerator, Polynomial denominator, const char* name);

}  // namespace nipref::ref
