#pragma once
#include <span>
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

/// Of the arguments of a moving load from its material on: material, bulk, tau, a series, operators. Roots of the
/// operators by the method of Durand and Kerner.
SolidTerms solid_terms(std::span<const double> x);

}  // namespace nipref::verify::confirm
