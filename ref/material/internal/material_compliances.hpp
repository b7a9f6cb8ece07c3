#pragma once
#include <vector>

#include <nipref/ref/material/exact_material.hpp>
#include <nipref/ref/number/internal/complex.hpp>

namespace nipref::ref {

/// The term amplitude e^(-rate t).
struct ComplianceTerm {
  ComplexFloat amplitude;  ///< 1/(stress time)
  ComplexFloat rate;       ///< 1/time; exactly 0 if the material's rate is 0
};
/// Whether the term is a constant, the flow of a fluid.
inline bool is_flow(const ComplianceTerm& term) { return term.rate.re == 0; }

/// theta(t) = at_once delta(t) + sum of the terms. Terms that are not real come in conjugate pairs.
struct Compliance {
  Float at_once;  ///< 1/stress
  std::vector<ComplianceTerm> terms;
};
/// The compliance to the working precision.
Compliance compliance_of(const ExactFunction& theta);

struct MaterialCompliances {
  Compliance theta1, theta2;
};

/// The compliances to the working precision, from the exact values of the material's constants or, without constants,
/// of its functions. Throws data::NoMaterial for operators that are no material.
MaterialCompliances material_compliances(const data::ViscoelasticMaterial& material);

}  // namespace nipref::ref
