#pragma once
#include <array>

#include <nipref/fast/half_space/indenter.hpp>
#include <nipref/fast/half_space/response.hpp>
#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

/// One load of an elliptic contact. The pressure is peak_pressure sqrt(1 - (x/a)^2 - (y/b)^2), x along the
/// major axis, y across.
struct EllipticLoad {
  Estimate semi_major, semi_minor;  ///< a >= b, unit of length
  Estimate approach;                ///< of the rigid body and the distant half-space, unit of length
  Estimate force;
  Estimate peak_pressure;  ///< unit of stress
};

/// The exact frictionless contact of a rigid smooth body with a half-space of any compliance K(psi), at rest
/// or moving steadily at a subcritical speed. A pressure p0 sqrt(1 - x^2/a^2 - y^2/b^2) displaces the
/// surface below it by (p0 a b/4) int_0^pi K(psi) (1 - (n.x)^2/w^2)/w dpsi, n = (cos psi, sin psi) and w(psi)
/// the half-width of the ellipse along n; so its ellipse follows from int K n n/w^3 dpsi being proportional
/// to the curvatures of the body. That is the stationary point of a function strictly concave in the matrix
/// of the ellipse, so that there is exactly one. It is found by Newton's method with line search. The integrals are
/// taken over the variable of the Jacobi amplitude, in which they stay smooth for slender ellipses, on panels that are
/// halved where K requires it (near critical lines) and made anew until the ellipse has converged.
class EllipticContact {
 public:
  /// The compliance must be positive and finite at every direction, else BadInput; the coupling is not used.
  /// Curvature ratios 1e-10 <= curvature_1/curvature_2 <= 1e10, BadInput otherwise.
  EllipticContact(const SurfaceResponse& response, const Indenter& body);

  [[nodiscard]] Estimate axis_ratio() const;  ///< b/a <= 1
  /// Angle of the major axis with x1, -pi/2 < angle <= pi/2; error up to pi/2 if the ellipse is a circle.
  [[nodiscard]] Estimate orientation() const;
  /// Distance of the edge from the centre over a, in a direction of unit length, else BadInput.
  [[nodiscard]] Estimate radius_ratio(Direction psi) const;
  /// The distance of the edge from the centre in the direction psi over that in the direction `to`.
  [[nodiscard]] Estimate span_ratio(Direction psi, Direction to) const;
  /// The pressure under a load of this contact at the distance x from the centre in the direction psi, 0 outside the
  /// contact; unit of stress. x must be finite and psi of unit length, else BadInput.
  [[nodiscard]] Estimate pressure(const EllipticLoad& load, Direction psi, double x) const;
  /// The displacement, against what is far away, of a half-space with these waves, which may be one of two bodies: along x1,
  /// along x2 and into it, unit of length, at the distance x from the centre in the direction psi, inside the contact or
  /// outside, at this depth below the surface; at depth 0 waves of the surface alone suffice. Accuracy: that of the ellipse,
  /// times their size where the first two vanish. x must be finite, the depth finite and >= 0, else BadInput. (brock2012 17,
  /// with its kernels corrected)
  [[nodiscard]] std::array<Estimate, 3> displacement(const EllipticLoad& load,
                                                     const PressureWaves& half_space, Direction psi, double x,
                                                     double depth = 0) const;
  [[nodiscard]] EllipticLoad for_force(double force) const;  ///< force > 0 and finite, else BadInput
  [[nodiscard]] EllipticLoad for_approach(
      double approach) const;  ///< > 0, finite, unit of length, else BadInput
  /// The load for which the edge is at the distance `radius` from the centre in the direction psi. The radius must be
  /// > 0 and finite, else BadInput; unit of length.
  [[nodiscard]] EllipticLoad for_radius(Direction psi, double radius) const;

 private:
  void set_errors(double e11, double e12, double e22);
  [[nodiscard]] EllipticLoad scaled(const Estimate& factor) const;

  double major_length_, minor_length_;  ///< of the ellipse that has int K n n/w^3 dpsi = curvatures
  Direction major_;
  double sum_;                                                                  ///< int K/w dpsi
  double major_error_ = 0, minor_error_ = 0, twist_error_ = 0, sum_error_ = 0;  ///< relative
  double turn_ = 0;  ///< error of the major axis's angle
};

}  // namespace nipref::fast
