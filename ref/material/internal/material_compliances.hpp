#pragma once
#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/ref/material/internal/rational_compliance.hpp>

namespace nipref::ref {

struct MaterialCompliances {
  Compliance theta1, theta2;
};

/// The compliances to the working precision, from the exact values of the material's constants or, without constants,
/// of its functions. Throws data::NoMaterial for operators that are no material.
MaterialCompliances material_compliances(const data::ViscoelasticMaterial& material);

}  // namespace nipref::ref
