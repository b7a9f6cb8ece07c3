#pragma once
#include <array>
#include <cstddef>
#include <utility>

#include <nipref/data/material/solids.hpp>

namespace nipref::data {

/// The row and the column of each constant, C11 to C66, in Voigt notation: row by row of the upper triangle.
inline constexpr auto upper_triangle = [] {
  std::array<std::pair<std::size_t, std::size_t>, 21> all{};
  std::size_t next = 0;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = i; k < 6; ++k) all[next++] = {i, k};
  return all;
}();

/// Sets a symmetric matrix in Voigt notation to the constants that an iterator gives in the order of upper_triangle.
void set_symmetric(auto& voigt, auto constants) {
  for (const auto& [i, k] : upper_triangle) voigt[i][k] = voigt[k][i] = *constants++;
}

/// Sets the constants of a solid whose axis of symmetry is x3 or x2 in a matrix of zeros.
template <class Number>
void set_transversely_isotropic(auto& voigt, SymmetryAxis axis, const Number& c11, const Number& c33,
                                const Number& c13, const Number& c44, const Number& c66) {
  const std::size_t along = axis == SymmetryAxis::normal ? 2 : 1;
  const Number c12 = c11 - 2 * c66;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const bool with_axis = i == along || k == along;
      voigt[i][k] = i == k ? (with_axis ? c33 : c11) : (with_axis ? c13 : c12);
    }
    // Shear in the plane perpendicular to direction i.
    voigt[i + 3][i + 3] = i == along ? c66 : c44;
  }
}

/// A general anisotropic solid in the axes of the half-space x3 > 0: C_ijkl as Voigt's symmetric 6x6 matrix
/// in the order 11, 22, 33, 23, 13, 12 (sigma = C epsilon with shear strains 2 epsilon_ij), unit of stress.
struct Stiffness {
  using Voigt = std::array<std::array<double, 6>, 6>;

  Voigt voigt;
  double density;

  /// Returns `unit` times the product of a factor and its transpose, symmetric to the last bit.
  static Voigt squared(const Voigt& factor, double unit = 1);

  /// Throws BadInput "stiffness" unless the matrix is finite, symmetric and positive definite (up to rounding: its
  /// Cholesky factor exists in double), and BadInput "density" unless the density is finite and > 0.
  void check() const;

  /// The constants of the solid, rounded to double if they are derived. Throws BadInput as its check() does.
  static Stiffness of(const IsotropicSolid& solid);

  /// The same for an axis normal to the surface, along x3, or in it, along x2, where x1 and x3 span the isotropic
  /// plane. (brock2013 (4), (37))
  static Stiffness of(const TransverselyIsotropicSolid& solid, SymmetryAxis axis);
};

}  // namespace nipref::data
