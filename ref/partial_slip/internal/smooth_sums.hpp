#pragma once
#include <nipref/ref/nip/internal/sheet_kernels.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/partial_slip/internal/zone_grid.hpp>

namespace nipref::ref {

/// Two components, or the left sides of both equations but for what the values at the point itself add.
template <class Number>
struct NormalAndTangential {
  Number normal, tangential;
};
using PointSums = NormalAndTangential<ComplexFloat>;

/// What the smooth parts of the kernels, U + 1/(pi alpha), V and S + 1/(pi alpha), make of p and q, by interpolation at
/// Chebyshev's points of the contact.
class SmoothSums {
 public:
  SmoothSums(const ZonePanels& panels, const ZoneGrid& grid, SheetKernels& kernels);

  void set(const OfBoth<Vector>& values);
  [[nodiscard]] PointSums at(const ComplexFloat& e) const;
  /// The tangential one beside the contact, where it is not interpolated.
  [[nodiscard]] Float strain(const Float& e) const;
  /// Of displacements, I1 + ln|alpha|, I3 and I6 + ln|alpha| over pi; up to a constant.
  [[nodiscard]] NormalAndTangential<Float> displacement(const Float& e) const;

  /// Lagrange's polynomials of the points.
  [[nodiscard]] Row<ComplexFloat> lagrange(const ComplexFloat& e) const;
  /// What U, V and S make at the points of all values.
  [[nodiscard]] std::array<Eigen::MatrixXd, 3> slopes() const;

 private:
  template <class Kernels>
  [[nodiscard]] NormalAndTangential<Float> applied(const Float& e, const Kernels& kernels_at) const;

  SheetKernels& kernels_;
  Row<Float> places_;             ///< of the points, with both ends
  Matrix integrals_;              ///< against Lagrange's polynomials, of all unit values
  std::array<Matrix, 3> smooth_;  ///< U, V and S between the points, without 1/(pi alpha)
  OfBoth<Vector> moments_;        ///< the integrals of p and q
  NormalAndTangential<Vector> at_points_;
};

}  // namespace nipref::ref
