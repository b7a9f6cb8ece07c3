#pragma once
#include <memory>

#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

// Sliding contacts of smooth rigid bodies in multiprecision, by the papers' rule from the response of the surface along
// lines. Errors are estimated.
//
//   digits      16 to 100. Results have a relative error of at most 10^-digits; BadInput "digits" where this is not reached
//   friction    coefficient, 0 to 1000
//   degrees     angle of a line from the motion

/// Omega = -1/2 + atan(friction (cos(psi) S - sin(psi) S')/K)/pi: the pressure on a line ends like (x+ -
/// x)^(1 + Omega) (x - x-)^(-Omega). (brock2012 26a, brock2013 29a)
Estimate sliding_exponent(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                          int digits);

/// A(psi) L(psi)/(A(0) L(0)), where A is the body's curvature along the line, by the papers' rule that the peak
/// pressures of all lines are equal. (brock2012 34a, brock2013 34)
Estimate sliding_span_ratio(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                            int digits);

/// F3/(C L^3) for a body with both curvatures C and the span L along the motion, unit of stress. The force is minus the
/// integral of sigma33 |x| over the lines of half a turn. (brock2012 36, brock2013 36 with Q^3)
Estimate sliding_force(const SurfaceAnswer& surface, const Exact& friction, int digits);

/// The rule by which the spans of the lines are related: the peak pressures are equal, or the spans follow the body's
/// own contours, like the root of its radius of curvature. (brock2012 33, 30)
enum class SpanRule { stationary_force, similar_contour };

/// The sliding contact of a body under a load. With force = factor span^3 the span for a given force follows in closed
/// form.
class SlidingContact {
 public:
  /// The integral over the lines is computed when it is first needed; BadInput "digits" where it does not converge.
  SlidingContact(SurfaceAnswer surface, const Indenter& body, const Exact& friction,
                 const HalfSpaceLoad& load, int digits, SpanRule rule = SpanRule::stationary_force);

  [[nodiscard]] Estimate span(const Exact& degrees) const;        ///< L(psi), unit of length
  [[nodiscard]] Estimate span_ratio(const Exact& degrees) const;  ///< L(psi)/L(0)
  [[nodiscard]] Estimate force() const;
  [[nodiscard]] Estimate peak_pressure() const;  ///< on the line along the motion, unit of stress
  [[nodiscard]] Estimate peak_pressure(const Exact& degrees) const;  ///< on that line
  [[nodiscard]] Estimate leading_end(const Exact& degrees) const;    ///< x+ = -Omega L, unit of length
  /// The pressure at x on a line, 0 outside the contact. The error includes that of the line's ends.
  [[nodiscard]] Estimate pressure(const Exact& degrees, const Exact& x) const;
  /// The first moment of the pressure about the point of first touch over the force, along the motion and across it,
  /// at 90 degrees; the error is relative to the span.
  [[nodiscard]] Estimate centre_along() const;
  [[nodiscard]] Estimate centre_across() const;

 private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

}  // namespace nipref::ref
