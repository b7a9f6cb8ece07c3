#pragma once
#include <vector>

#include <nipref/ref/material/exact_material.hpp>
#include <nipref/ref/number/internal/complex.hpp>

namespace nipref::ref {

/// The term amplitude e^(-rate t).
struct ComplianceTerm {
  ComplexFloat amplitude;  ///< 1/(stress time)
  ComplexFloat rate;       ///< 1/time; exactly 0 if the function's is
};
/// Whether it never fades.
inline bool is_flow(const ComplianceTerm& term) { return term.rate.re == 0; }

/// theta(t) = at_once delta(t) + sum of the terms; those that are not real stand in conjugate pairs.
struct Compliance {
  Float at_once;  ///< 1/stress
  std::vector<ComplianceTerm> terms;
};
/// To the working precision.
Compliance compliance_of(const ExactFunction& theta);

struct MaterialCompliances {
  Compliance theta1, theta2;
};

/// The compliances to the working precision, from the exact values of the material's constants or, without constants,
/// of its functions. Throws data::NoMaterial for operators that are no material.
MaterialCompliances material_compliances(const data::ViscoelasticMaterial& material);

}  // namespace nipref::ref
