#include <nipref/ref/half_space/stiffness.hpp>

namespace nipref::ref {
namespace {

struct ExactTransverse {
  mpq_class c11, c33, c13, c44, c66, density;
};

ExactStiffness assemble(const ExactTransverse& solid, std::size_t along) {
  ExactStiffness result;
  result.density = solid.density;
  const mpq_class c12 = solid.c11 - 2 * solid.c66;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const bool with_axis = i == along || k == along;
      result.voigt[i][k] = i == k ? (with_axis ? solid.c33 : solid.c11) : (with_axis ? solid.c13 : c12);
    }
    result.voigt[i + 3][i + 3] = i == along ? solid.c66 : solid.c44;
  }
  return result;
}

}  // namespace

ExactStiffness exact_stiffness(const data::Stiffness& solid) {
  solid.check();
  ExactStiffness result;
  result.density = solid.density;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < 6; ++k) result.voigt[i][k] = solid.voigt[i][k];
  }
  return result;
}

ExactStiffness exact_stiffness(const data::IsotropicSolid& solid) {
  solid.check();
  const mpq_class shear(solid.shear);
  const mpq_class poisson(solid.poisson);
  const mpq_class lame = 2 * shear * poisson / (1 - 2 * poisson);
  const mpq_class longitudinal = lame + 2 * shear;
  return assemble({longitudinal, longitudinal, lame, shear, shear, solid.density}, 2);
}

ExactStiffness exact_stiffness(const data::TransverselyIsotropicSolid& solid, data::SymmetryAxis axis) {
  solid.check();
  return assemble({solid.c11, solid.c33, solid.c13, solid.c44, solid.c66, solid.density},
                  axis == data::SymmetryAxis::normal ? 2 : 1);
}

ExactStiffness sagittal_stiffness(const data::TransverselyIsotropicSolid& solid) {
  solid.check();
  return assemble({solid.c11, solid.c33, solid.c13, solid.c44, solid.c11, solid.density}, 2);
}

}  // namespace nipref::ref
