#pragma once
#include <gmpxx.h>

#include <array>
#include <variant>

#include <nipref/data/material/stiffness.hpp>
#include <nipref/data/problem/half_space.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// data::TransverselyIsotropicSolid with exact constants. Moduli that follow from others (C12 = C11 - 2 C66, or
/// Lame's from Poisson's ratio) are computed without rounding, so that an isotropic solid is exactly isotropic.
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

/// data::Stiffness with exact constants.
struct ExactStiffness {
  std::array<std::array<mpq_class, 6>, 6> voigt;
  mpq_class density;
};

/// The same doubles as exact numbers; BadInput as thrown by check().
ExactStiffness exact_stiffness(const data::Stiffness& solid);
ExactStiffness exact_stiffness(const ExactTransverse& solid, data::SymmetryAxis axis);

/// For axis `normal`: a solid with the same motion in the sagittal plane of every line, in which c66 (and with it
/// c12) is raised to c11. Sagittal motion does not depend on c66. Where c66 < c44, horizontally polarised waves would
/// otherwise set the limiting speed, although they do not contribute to the normal response. `across` of its response
/// is not that of the solid, and its strain energy may be indefinite. (brock2013 sec. 3)
ExactStiffness sagittal_stiffness(const ExactTransverse& solid);

/// A smooth rigid body at the point where it touches the plane, known exactly: its curvatures along the motion
/// and across it, 1/length, > 0.
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
