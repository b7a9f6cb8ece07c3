#pragma once

namespace nipref::data {

// The solids of half-spaces and of spheres on them. `check` throws BadInput naming the member. Moduli in stress,
// density in mass/volume, all consistent with the unit of speed.

/// An isotropic solid. Its strain energy is positive: shear > 0, -1 < poisson < 1/2.
struct IsotropicSolid {
  double shear;    ///< shear modulus mu
  double poisson;  ///< Poisson's ratio
  double density;

  void check() const;
};

/// A transversely isotropic solid with the axis of symmetry x3; C12 = C11 - 2 C66. Its strain energy is positive: c33,
/// c44, c66 > 0, c11 > c66 and (c11 - c66) c33 > c13^2. (brock2013 (4), (A.4))
struct TransverselyIsotropicSolid {
  double c11;  ///< across the axis
  double c33;  ///< along the axis
  double c13;
  double c44;  ///< shear in planes with the axis
  double c66;  ///< shear across the axis
  double density;

  void check() const;
};

/// The direction of the axis of symmetry relative to the surface of the half-space.
enum class SymmetryAxis { normal, in_plane };

}  // namespace nipref::data
