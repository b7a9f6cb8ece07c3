#pragma once
#include <nipref/data/material/viscoelastic.hpp>

namespace nipref::fast {

/// The material's compliances as sums of exponentials, each number rounded to double: as they were given, or with the
/// roots of the operators, found in 237 bits. Throws data::NoMaterial for operators that are no material.
data::MaterialFunctions material_functions(const data::ViscoelasticMaterial& material);

}  // namespace nipref::fast
