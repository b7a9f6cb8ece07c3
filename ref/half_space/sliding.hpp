#pragma once
#include <memory>

#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

// Sliding contacts of smooth rigid bodies in multiprecision. By the rule of brock2012 and brock2013, the pressure on
// each line of the contact follows from the response of the surface along this line alone. Errors are estimated.
//
//   digits      16 to 100. Results have a relative error of at most 10^-digits; BadInput "digits" if this is not reached
//   friction    coefficient, 0 to 1000
//   degrees     angle psi of a line from the motion
//
// K, S and S' are compliance, coupling and coupling_across of a line, see LineResponse; K includes friction (cos(psi)
// shear_compliance - sin(psi) shear_compliance_across). L(psi) is the span, the length of the contact on a line.

/// Omega = -1/2 + atan(friction (cos(psi) S - sin(psi) S')/K)/pi, dimensionless. The pressure on a line is proportional
/// to (x+ - x)^(1 + Omega) (x - x-)^(-Omega). (brock2012 26a, brock2013 29a)
Estimate sliding_exponent(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                          int digits);

/// A(psi) L(psi)/(A(0) L(0)), where A is the body's curvature along the line, by the rule that the peak pressures of
/// all lines are equal. (brock2012 34a, brock2013 34)
Estimate sliding_span_ratio(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                            int digits);

/// F3/(C L(0)^3), unit of stress, for a body with both curvatures C. The force F3 is minus the integral of sigma33 |x|
/// over the lines of half a turn. (brock2012 36, brock2013 36 with Q^3)
Estimate sliding_force(const SurfaceAnswer& surface, const Exact& friction, int digits);

/// The rule that relates the spans of the lines. stationary_force: the peak pressures are equal (brock2012 33).
/// similar_contour: the spans are proportional to the square root of the body's radius of curvature (brock2012 30).
enum class SpanRule { stationary_force, similar_contour };

/// The sliding contact of a body under a load. As force = factor span^3, the span for a force follows in closed form.
class SlidingContact {
 public:
  /// The integral over the lines is computed when it is first needed; BadInput "digits" if it does not converge.
  SlidingContact(SurfaceAnswer surface, const Indenter& body, const Exact& friction,
                 const HalfSpaceLoad& load, int digits, SpanRule rule = SpanRule::stationary_force);

  [[nodiscard]] Estimate span(const Exact& degrees) const;        ///< L(psi), unit of length
  [[nodiscard]] Estimate span_ratio(const Exact& degrees) const;  ///< L(psi)/L(0)
  [[nodiscard]] Estimate force() const;
  [[nodiscard]] Estimate peak_pressure() const;  ///< on the line along the motion, unit of stress
  [[nodiscard]] Estimate peak_pressure(const Exact& degrees) const;  ///< on the line psi
  [[nodiscard]] Estimate leading_end(const Exact& degrees) const;    ///< x+ = -Omega L, unit of length
  /// The pressure at x on a line, 0 outside the contact. The error includes that of the line's ends.
  [[nodiscard]] Estimate pressure(const Exact& degrees, const Exact& x) const;
  /// The coordinates of the centre of pressure along the motion and across it, at 90 degrees, from the point of first
  /// touch. The errors are relative to the span.
  [[nodiscard]] Estimate centre_along() const;
  [[nodiscard]] Estimate centre_across() const;

 private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

}  // namespace nipref::ref
