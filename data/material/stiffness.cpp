#include <nipref/data/internal/common.hpp>
#include <nipref/data/material/stiffness.hpp>

namespace nipref::data {
namespace {

/// Tests whether Cholesky's factor of the matrix, scaled to a unit diagonal, exists: units do not matter then.
bool is_positive_definite(const Stiffness::Voigt& matrix) {
  Stiffness::Voigt factor{};
  for (std::size_t i = 0; i < 6; ++i) {
    if (!(matrix[i][i] > 0)) return false;
    for (std::size_t k = 0; k <= i; ++k) {
      double rest = matrix[i][k] / std::sqrt(matrix[i][i]) / std::sqrt(matrix[k][k]);
      for (std::size_t j = 0; j < k; ++j) rest -= factor[i][j] * factor[k][j];
      if (i == k && !(rest > 0)) return false;
      factor[i][k] = i == k ? std::sqrt(rest) : rest / factor[k][k];
    }
  }
  return true;
}

}  // namespace

Stiffness::Voigt Stiffness::squared(const Voigt& factor, double unit) {
  Voigt product{};
  for (const auto& [i, k] : upper_triangle) {
    double sum = 0;
    for (std::size_t j = 0; j < 6; ++j) sum += factor[i][j] * factor[k][j];
    product[i][k] = product[k][i] = unit * sum;
  }
  return product;
}

void Stiffness::check() const {
  if (!(std::isfinite(density) && density > 0)) throw BadInput("density", density, "must be finite and > 0");
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < 6; ++k) {
      if (!std::isfinite(voigt[i][k])) throw BadInput("stiffness", voigt[i][k], "must be finite");
      if (voigt[i][k] != voigt[k][i]) throw BadInput("stiffness", voigt[i][k], "must be a symmetric matrix");
    }
  }
  if (!is_positive_definite(voigt)) {
    throw BadInput("stiffness", voigt[0][0], "must be a positive definite matrix (this is its C11)");
  }
}

Stiffness Stiffness::of(const IsotropicSolid& solid) {
  solid.check();
  const double lame = 2 * solid.shear * solid.poisson / (1 - 2 * solid.poisson);
  return of({lame + 2 * solid.shear, lame + 2 * solid.shear, lame, solid.shear, solid.shear, solid.density},
            SymmetryAxis::normal);
}

Stiffness Stiffness::of(const TransverselyIsotropicSolid& solid, SymmetryAxis axis) {
  solid.check();
  Stiffness result{{}, solid.density};
  set_transversely_isotropic(result.voigt, axis, solid.c11, solid.c33, solid.c13, solid.c44, solid.c66);
  return result;
}

}  // namespace nipref::data
