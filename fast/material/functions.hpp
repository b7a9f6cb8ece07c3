#pragma once
#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/fast/material/moduli.hpp>
#include <nipref/fast/material/rational_solid.hpp>

namespace nipref::fast {

/// The material's compliances as sums of exponentials, either as they were given or from the roots of the operators, which
/// are found in 237 bits. Each number is rounded to double. Throws data::NoMaterial for operators that are no material.
data::MaterialFunctions material_functions(const data::ViscoelasticMaterial& material);

// theta1 and theta2 of any material of these constants, whether a sheet may be made of it or not. Each number is
// rounded once. Throws data::NoMaterial if two distinct rates agree to 1e-6. (thesis AIII.5-AIII.8)

data::MaterialFunctions material_functions(const Modulus& shear, const Modulus& bulk);
data::MaterialFunctions material_functions(const RationalSolid& solid);

}  // namespace nipref::fast
