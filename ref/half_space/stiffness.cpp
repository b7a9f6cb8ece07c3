#include <nipref/ref/half_space/stiffness.hpp>

namespace nipref::ref {

ExactTransverse::ExactTransverse(const Exact& the_c11, const Exact& the_c33, const Exact& the_c13,
                                 const Exact& the_c44, const Exact& the_c66, const Exact& the_density)
    : c11(the_c11.value()),
      c33(the_c33.value()),
      c13(the_c13.value()),
      c44(the_c44.value()),
      c66(the_c66.value()),
      density(the_density.value()) {
  data::TransverselyIsotropicSolid{the_c11.approximate(), the_c33.approximate(), the_c13.approximate(),
                                   the_c44.approximate(), the_c66.approximate(), the_density.approximate()}
      .check();
}

ExactTransverse::ExactTransverse(const data::TransverselyIsotropicSolid& solid)
    : ExactTransverse(Exact(solid.c11, "c11"), Exact(solid.c33, "c33"), Exact(solid.c13, "c13"),
                      Exact(solid.c44, "c44"), Exact(solid.c66, "c66"), Exact(solid.density, "density")) {}

ExactTransverse::ExactTransverse(const data::IsotropicSolid& solid)
    : ExactTransverse(isotropic(Exact(solid.shear, "shear"), Exact(solid.poisson, "poisson"),
                                Exact(solid.density, "density"))) {}

ExactTransverse ExactTransverse::isotropic(const Exact& shear, const Exact& poisson, const Exact& density) {
  data::IsotropicSolid{shear.approximate(), poisson.approximate(), density.approximate()}.check();
  ExactTransverse result;
  result.c13 = 2 * shear.value() * poisson.value() / (1 - 2 * poisson.value());
  result.c11 = result.c33 = result.c13 + 2 * shear.value();
  result.c44 = result.c66 = shear.value();
  result.density = density.value();
  return result;
}

ExactTransverse ExactTransverse::over(const mpq_class& stress, const mpq_class& unit_density) const {
  ExactTransverse result(*this);
  for (mpq_class* modulus : {&result.c11, &result.c33, &result.c13, &result.c44, &result.c66})
    *modulus /= stress;
  result.density /= unit_density;
  return result;
}

ExactStiffness exact_stiffness(const data::Stiffness& solid) {
  solid.check();
  ExactStiffness result;
  result.density = solid.density;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < 6; ++k) result.voigt[i][k] = solid.voigt[i][k];
  }
  return result;
}

ExactStiffness exact_stiffness(const ExactTransverse& solid, data::SymmetryAxis axis) {
  ExactStiffness result;
  result.density = solid.density;
  data::set_transversely_isotropic(result.voigt, axis, solid.c11, solid.c33, solid.c13, solid.c44, solid.c66);
  return result;
}

ExactStiffness sagittal_stiffness(const ExactTransverse& solid) {
  ExactTransverse raised = solid;
  raised.c66 = solid.c11;
  return exact_stiffness(raised, data::SymmetryAxis::normal);
}

}  // namespace nipref::ref
