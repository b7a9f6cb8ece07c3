#pragma once
#include <gmpxx.h>

#include <array>

#include <nipref/data/material/stiffness.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// data::TransverselyIsotropicSolid, known exactly. The moduli that a solid's constants imply (C12 = C11 - 2
/// C66, or Lame's from Poisson's ratio) are formed without rounding, so an isotropic solid is exactly
/// isotropic.
struct ExactTransverse {
  mpq_class c11, c33, c13, c44, c66, density;

  /// BadInput, naming the constant, where the nearest doubles are refused by data's check().
  ExactTransverse(const Exact& the_c11, const Exact& the_c33, const Exact& the_c13, const Exact& the_c44,
                  const Exact& the_c66, const Exact& the_density);
  ExactTransverse(const data::TransverselyIsotropicSolid& solid);
  ExactTransverse(const data::IsotropicSolid& solid);
  static ExactTransverse isotropic(const Exact& shear, const Exact& poisson, const Exact& density);

  /// The same solid in other units.
  [[nodiscard]] ExactTransverse over(const mpq_class& stress, const mpq_class& unit_density) const;

 private:
  ExactTransverse() = default;
};

/// data::Stiffness, known exactly.
struct ExactStiffness {
  std::array<std::array<mpq_class, 6>, 6> voigt;
  mpq_class density;
};

/// The doubles, exactly; BadInput as check() throws.
ExactStiffness exact_stiffness(const data::Stiffness& solid);
ExactStiffness exact_stiffness(const ExactTransverse& solid, data::SymmetryAxis axis);

/// For axis `normal`: a solid that moves in the sagittal plane of every line exactly as this one, but with
/// c66 (and c12 with it) raised to c11. Sagittal motion does not see c66, while its horizontally polarised
/// waves would set the limiting speed where c66 < c44, although they have no part in the normal response. Of
/// the response `across` is not the solid's; the strain energy may be indefinite. (brock2013 sec. 3)
ExactStiffness sagittal_stiffness(const ExactTransverse& solid);

}  // namespace nipref::ref
