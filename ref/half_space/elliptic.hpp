#pragma once
#include <array>
#include <functional>
#include <memory>

#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

// The exact frictionless contact of a smooth rigid body in multiprecision, from the response of the surface along
// lines. Errors are estimated.
//
//   curvature_ratio   the body's curvature across the motion over that along it, 1e-12 to 1e12; 1 for a
//                     sphere. BadInput otherwise
//   digits            16 to 100. Results have a relative error of at most 10^-digits; BadInput "digits" where this is
//                     not reached, as for slender ellipses that are oblique to a peak of the compliance, which need
//                     more lines than are tried. Ellipses along or across the peak may be as slender as 1e-7, at
//                     speeds up to 1 - 1e-9 of the critical one

/// The minor over the major axis of the ellipse whose half-widths w make int K n n/w^3 dpsi proportional to the
/// curvatures. By Newton's method for the logarithm of the ratio and the angle.
Estimate elliptic_axis_ratio(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits);

/// F/(sqrt(R) delta^(3/2)) of that contact, 1/R the mean of the two curvatures and delta the approach: (8
/// pi/3) I3^(1/2)/I1^(3/2) with In = int K/w^n dpsi over half a turn; unit of stress. A sphere at rest:
/// Hertz's 8/(3 K).
Estimate elliptic_stiffness(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits);

/// The whole contact for a body and a load. All results depend on the load through powers of one length scale, in
/// closed form.
class EllipticContact {
 public:
  /// The domain of the curvature ratio is that given above.
  EllipticContact(SurfaceAnswer surface, const Indenter& body, const HalfSpaceLoad& load, int digits);

  [[nodiscard]] Estimate axis_ratio() const;  ///< minor over major axis
  /// The angle of the major axis from the motion in degrees, -90 to 90; the error is 90 if the ellipse is a circle.
  [[nodiscard]] Estimate orientation() const;
  [[nodiscard]] Estimate span(const Exact& degrees) const;        ///< diameter, unit of length
  [[nodiscard]] Estimate span_ratio(const Exact& degrees) const;  ///< over that along the motion
  [[nodiscard]] Estimate approach() const;
  [[nodiscard]] Estimate force() const;
  [[nodiscard]] Estimate peak_pressure() const;
  /// The pressure at x on a line, 0 outside the contact.
  [[nodiscard]] Estimate pressure(const Exact& degrees, const Exact& x) const;
  /// The displacement at x on a line: along the motion, across it and into the half-space, unit of length.
  using Displacement = std::function<std::array<Estimate, 3>(const Exact& degrees, const Exact& x)>;
  /// That of a half-space, which may be one of two bodies, at this depth below the surface, against what is far away. The
  /// half-space's lines are computed once for all places; below the surface its answers must have a decay. BadInput
  /// "depth" if it is negative, "surface" where the answers are not smooth from line to line.
  [[nodiscard]] Displacement displacement(const SurfaceAnswer& half_space, const Exact& depth) const;

 private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

}  // namespace nipref::ref
