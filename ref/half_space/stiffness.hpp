#pragma once
#include <gmpxx.h>

#include <array>
#include <variant>

#include <nipref/data/material/stiffness.hpp>
#include <nipref/data/problem/half_space.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// data::TransverselyIsotropicSolid with exact constants. Dependent moduli (C12 = C11 - 2 C66, or Lame's constant from
/// Poisson's ratio) are computed without rounding, so that an isotropic solid is exactly isotropic.
struct ExactTransverse {
  mpq_class c11, c33, c13, c44, c66, density;

  /// BadInput, naming the constant, if data's check() refuses the nearest doubles.
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

/// data::Stiffness with exact constants.
struct ExactStiffness {
  std::array<std::array<mpq_class, 6>, 6> voigt;
  mpq_class density;
};

/// The stiffness whose constants are the exact values of the doubles; BadInput if data's check() refuses them.
ExactStiffness exact_stiffness(const data::Stiffness& solid);
ExactStiffness exact_stiffness(const ExactTransverse& solid, data::SymmetryAxis axis);

/// The solid with the axis `normal`, but with c66 (and with it c12) raised to c11. Motion in the sagittal plane of any
/// line does not depend on c66 and is therefore the same. If c66 < c44, horizontally polarised waves of the original
/// solid set its limiting speed, although they do not contribute to the normal response. The component `across` of the
/// response differs from that of the original solid, and the strain energy may be indefinite. (brock2013 sec. 3)
ExactStiffness sagittal_stiffness(const ExactTransverse& solid);

/// The curvatures > 0 of a smooth rigid body along the motion and across it, 1/length, where it touches the plane.
struct Indenter {
  Exact along, across;

  /// A body given by its radii of curvature, > 0.
  static Indenter of_radii(double radius_along, double radius_across) {
    return {Exact(mpq_class(1 / mpq_class(radius_along))), Exact(mpq_class(1 / mpq_class(radius_across)))};
  }
};

/// The load on a contact; its doubles are taken as exact numbers.
using HalfSpaceLoad = std::variant<data::GivenNormalForce, data::GivenSpan>;

}  // namespace nipref::ref
