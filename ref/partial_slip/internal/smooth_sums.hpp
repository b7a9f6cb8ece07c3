#pragma once
#include <nipref/ref/nip/internal/sheet_kernels.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/partial_slip/internal/zone_grid.hpp>

namespace nipref::ref {

/// Two components, for example the left sides of both equations without the local terms.
template <class Number>
struct NormalAndTangential {
  Number normal, tangential;
};
using PointSums = NormalAndTangential<ComplexFloat>;

/// The integrals of p and q times the smooth parts of the kernels, U + 1/(pi alpha), V and S + 1/(pi alpha), by
/// interpolation at Chebyshev's points of the contact.
class SmoothSums {
 public:
  SmoothSums(const ZonePanels& panels, const ZoneGrid& grid, SheetKernels& kernels);

  void set(const OfBoth<Vector>& values);
  [[nodiscard]] PointSums at(const ComplexFloat& e) const;
  /// The tangential integral outside the contact, where it is not interpolated.
  [[nodiscard]] Float strain(const Float& e) const;
  /// The same with the kernels of displacements, I1 + ln|alpha|, I3 and I6 + ln|alpha| over pi, up to a constant.
  [[nodiscard]] NormalAndTangential<Float> displacement(const Float& e) const;

  /// Lagrange's polynomials of the points, at e.
  [[nodiscard]] Row<ComplexFloat> lagrange(const ComplexFloat& e) const;
  /// The integrals of all unit values times the smooth U, V and S, at the points.
  [[nodiscard]] std::array<Eigen::MatrixXd, 3> slopes() const;

 private:
  template <class Kernels>
  [[nodiscard]] NormalAndTangential<Float> applied(const Float& e, const Kernels& kernels_at) const;

  SheetKernels& kernels_;
  Row<Float> places_;             ///< Chebyshev's points, with both ends
  Matrix integrals_;              ///< of all unit values times Lagrange's polynomials
  std::array<Matrix, 3> smooth_;  ///< U, V and S between the points, without 1/(pi alpha)
  OfBoth<Vector> moments_;        ///< integrals of p and q times Lagrange's polynomials
  NormalAndTangential<Vector> at_points_;
};

}  // namespace nipref::ref
