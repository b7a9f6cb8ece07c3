#pragma once
#include <gmpxx.h>

#include <array>

#include "data/stiffness.hpp"

namespace nipref::ref {

/// data::Stiffness, known exactly. The moduli that a solid's constants imply (C12 = C11 - 2 C66, or Lame's
/// from Poisson's ratio) are formed without rounding, so an isotropic solid is exactly isotropic.
struct ExactStiffness {
  std::array<std::array<mpq_class, 6>, 6> voigt;
  mpq_class density;
};

/// The doubles, exactly; BadInput as check() throws.
ExactStiffness exact_stiffness(const data::Stiffness& solid);
ExactStiffness exact_stiffness(const data::IsotropicSolid& solid);
ExactStiffness exact_stiffness(const data::TransverselyIsotropicSolid& solid, data::SymmetryAxis axis);

}  // namespace nipref::ref
