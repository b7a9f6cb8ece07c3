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

/// The exact frictionless contact of a rigid smooth body with a half-space of any compliance K(psi), at rest or moving
/// steadily at a subcritical speed. A pressure p0 sqrt(1 - x^2/a^2 - y^2/b^2) displaces the surface below it by
/// (p0 a b/4) int_0^pi K(psi) (1 - (n.x)^2/w^2)/w dpsi, where n = (cos psi, sin psi) and w(psi) is the half-width of the
/// ellipse along n. Hence in the ellipse of the contact int K n n/w^3 dpsi is proportional to the curvatures of the
/// body. This is the condition for a stationary point of a function that is strictly concave in the matrix of the
/// ellipse, so that there is exactly one such ellipse. Newton's method with line search finds it. The variable of
/// integration is that of the Jacobi amplitude, in which the integrands stay smooth for slender ellipses. Panels are
/// halved where K requires it, near critical lines, and are adapted again until the ellipse has converged.
class EllipticContact {
 public:
  /// The compliance must be positive and finite in every direction, and 1e-10 <= curvature_1/curvature_2 <= 1e10;
  /// otherwise BadInput. The coupling is not used.
  EllipticContact(const SurfaceResponse& response, const Indenter& body);

  [[nodiscard]] Estimate axis_ratio() const;  ///< b/a <= 1
  /// The angle of the major axis with x1, -pi/2 < angle <= pi/2. The error is up to pi/2 if the ellipse is a circle.
  [[nodiscard]] Estimate orientation() const;
  /// The distance of the edge from the centre over a, in the direction psi; psi is of unit length, else BadInput.
  [[nodiscard]] Estimate radius_ratio(Direction psi) const;
  /// The ratio of the distances of the edge from the centre in the directions psi and `to`.
  [[nodiscard]] Estimate span_ratio(Direction psi, Direction to) const;
  /// The pressure under a load of this contact at the distance x from the centre in the direction psi, 0 outside the
  /// contact; unit of stress. x must be finite and psi of unit length, else BadInput.
  [[nodiscard]] Estimate pressure(const EllipticLoad& load, Direction psi, double x) const;
  /// The displacement of a half-space with these waves relative to distant points: along x1, along x2 and into the
  /// half-space, unit of length. The half-space may be one of two bodies. The point is at the distance x from the centre
  /// in the direction psi, inside or outside the contact, at this depth; at depth 0 waves of the surface alone suffice.
  /// The relative accuracy is that of the ellipse; where the first two components vanish, it is relative to the size of
  /// their terms. x must be finite, the depth finite and >= 0; otherwise BadInput. (brock2012 17, its kernels corrected)
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

  double major_length_, minor_length_;  ///< semi-axes for which int K n n/w^3 dpsi = curvatures
  Direction major_;
  double sum_;                                                                  ///< int K/w dpsi
  double major_error_ = 0, minor_error_ = 0, twist_error_ = 0, sum_error_ = 0;  ///< relative
  double turn_ = 0;  ///< error of the angle of the major axis
};

}  // namespace nipref::fast
