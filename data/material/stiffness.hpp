#pragma once
#include <array>

#include <nipref/data/material/solids.hpp>

namespace nipref::data {

/// A general anisotropic solid in the axes of the half-space x3 > 0: C_ijkl as Voigt's symmetric 6x6 matrix
/// in the order 11, 22, 33, 23, 13, 12 (sigma = C epsilon with shear strains 2 epsilon_ij), unit of stress.
struct Stiffness {
  using Voigt = std::array<std::array<double, 6>, 6>;

  Voigt voigt;
  double density;

  /// BadInput "stiffness" unless finite, symmetric and positive definite (to rounding: its Cholesky
  /// factor exists in double); BadInput "density" unless finite and > 0.
  void check() const;

  /// The solid's constants, rounded to double where they are derived; BadInput as its check() throws.
  static Stiffness of(const IsotropicSolid& solid);

  /// Axis normal: along x3; in_plane: along x2, so that x1, x3 span the isotropic plane. (brock2013 (4),
  /// (37))
  static Stiffness of(const TransverselyIsotropicSolid& solid, SymmetryAxis axis);
};

}  // namespace nipref::data
