#pragma once
#include <gmpxx.h>

#include <array>

#include <nipref/data/material/stiffness.hpp>

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

/// For axis `normal`: a solid that moves in the sagittal plane of every line exactly as this one, but with
/// c66 (and c12 with it) raised to c11. Sagittal motion does not see c66, while its horizontally polarised
/// waves would set the limiting speed where c66 < c44, although they have no part in the normal response. Of
/// the response `across` is not the solid's; the strain energy may be indefinite. (brock2013 sec. 3)
ExactStiffness sagittal_stiffness(const data::TransverselyIsotropicSolid& solid);

}  // namespace nipref::ref
