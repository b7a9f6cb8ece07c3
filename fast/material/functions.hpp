#pragma once
#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/fast/material/moduli.hpp>
#include <nipref/fast/material/rational_solid.hpp>

namespace nipref::fast {

/// The material's compliances as sums of exponentials, each number rounded to double: as they were given, or with the
/// roots of the operators, found in 237 bits. Throws data::NoMaterial for operators that are no material.
data::MaterialFunctions material_functions(const data::ViscoelasticMaterial& material);

// theta1 and theta2 of any material of these constants, whether a sheet may be made of it or not; each number is rounded
// once. Throws data::NoMaterial for rates that agree to 1e-6 and are not one. (thesis AIII.5-AIII.8)

data::MaterialFunctions material_functions(const Modulus& shear, const Modulus& bulk);
data::MaterialFunctions material_functions(const RationalSolid& solid);

}  // namespace nipref::fast
