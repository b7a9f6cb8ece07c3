#pragma once
#include <array>
#include <functional>
#include <memory>

#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

// The exact frictionless contact of a smooth rigid body in multiprecision, from the response of the surface along
// lines. Errors are estimated. The contact is an ellipse; w(psi) is half its extent in the direction n of a line.
//
//   curvature_ratio   the body's curvature across the motion over its curvature along the motion, 1e-12 to 1e12; 1 for a
//                     sphere. BadInput otherwise
//   digits            16 to 100. Results have a relative error of at most 10^-digits. BadInput "digits" if this needs too
//                     many lines, as for slender ellipses oblique to a peak of the compliance. Ellipses along or across
//                     the peak may be as slender as 1e-7, at speeds up to 1 - 1e-9 of the critical speed

/// The minor over the major axis of the ellipse for which int K n n/w^3 dpsi is proportional to the curvatures.
/// Newton's method solves for the logarithm of the ratio and the angle.
Estimate elliptic_axis_ratio(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits);

/// F/(sqrt(R) delta^(3/2)) of the contact, unit of stress, where 1/R is the mean of the two curvatures and delta the
/// approach. It is (8 pi/3) I3^(1/2)/I1^(3/2) with In = int K/w^n dpsi over half a turn. For a sphere at rest it is
/// Hertz's 8/(3 K).
Estimate elliptic_stiffness(const SurfaceAnswer& surface, const Exact& curvature_ratio, int digits);

/// The contact of a body under a load. All results are powers of one length scale, which depends on the load.
class EllipticContact {
 public:
  /// across/along of the body has the domain of curvature_ratio above.
  EllipticContact(SurfaceAnswer surface, const Indenter& body, const HalfSpaceLoad& load, int digits);

  [[nodiscard]] Estimate axis_ratio() const;  ///< minor over major axis
  /// The angle from the motion to the major axis in degrees, -90 to 90; the error is 90 if the ellipse is a circle.
  [[nodiscard]] Estimate orientation() const;
  [[nodiscard]] Estimate span(const Exact& degrees) const;        ///< diameter, unit of length
  [[nodiscard]] Estimate span_ratio(const Exact& degrees) const;  ///< span over the span along the motion
  [[nodiscard]] Estimate approach() const;
  [[nodiscard]] Estimate force() const;
  [[nodiscard]] Estimate peak_pressure() const;
  /// The pressure at x on a line, 0 outside the contact.
  [[nodiscard]] Estimate pressure(const Exact& degrees, const Exact& x) const;
  /// The displacement at x on a line: along the motion, across it and into the half-space, unit of length.
  using Displacement = std::function<std::array<Estimate, 3>(const Exact& degrees, const Exact& x)>;
  /// The displacement of a half-space, which may be one of the two bodies, at a depth below its surface and relative to
  /// distant points. `half_space` answers for this half-space alone, with a decay if the depth is not 0. Its lines are
  /// computed once for all places. BadInput "depth" if the depth is negative, "surface" if the answers are not smooth
  /// functions of the angle.
  [[nodiscard]] Displacement displacement(const SurfaceAnswer& half_space, const Exact& depth) const;

 private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

}  // namespace nipref::ref
