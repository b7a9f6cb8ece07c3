#pragma once
#include <vector>

#include <nipref/verify/golden/confirm/history.hpp>

namespace nipref::verify::confirm {

/// instantaneous delta(t) + sum amplitude e^(-rate t)
struct SolidFunction {
  struct Term {
    LongComplex amplitude, rate;
  };
  Long instantaneous;
  std::vector<Term> terms;
};

struct SolidTerms {
  SolidFunction theta1, theta2;
};

/// The material of a moving load. Roots of the operators by the method of Durand and Kerner.
SolidTerms solid_terms(Arguments x);

}  // namespace nipref::verify::confirm
