#pragma once
#include <memory>

#include <nipref/ref/half_space/indenter.hpp>
#include <nipref/ref/half_space/response.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

// Sliding contacts of smooth rigid bodies in multiprecision, by the papers' rule and from what the surface
// answers along lines; errors are estimated.
//
//   digits      16 to 100. Results are good to 10^-digits of themselves; BadInput "digits" where they are not
//   friction    coefficient, 0 to 1000
//   degrees     angle of a line from the motion

/// Omega = -1/2 + atan(friction (cos(psi) S - sin(psi) S')/K)/pi: the pressure on a line ends like (x+ -
/// x)^(1 + Omega) (x - x-)^(-Omega). (brock2012 26a, brock2013 29a)
Estimate sliding_exponent(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                          int digits);

/// A(psi) L(psi)/(A(0) L(0)), A the body's curvature along the line: spans of the contact by the papers'
/// rule, that peak pressures are equal. (brock2012 34a, brock2013 34)
Estimate sliding_span_ratio(const SurfaceAnswer& surface, const Exact& friction, const Exact& degrees,
                            int digits);

/// F3/(C L^3) of a body of equal curvatures C, L its span along the motion; unit of stress: minus the
/// integral of sigma33 |x| over the lines of half a turn. (brock2012 36, brock2013 36 with Q^3)
Estimate sliding_force(const SurfaceAnswer& surface, const Exact& friction, int digits);

/// How the spans of the lines go together: such that peak pressures are equal, or as the body's own contours, like the
/// root of its radius of curvature. (brock2012 33, 30)
enum class SpanRule { stationary_force, similar_contour };

/// All of that for a body and a load. Force = factor span^3 is monotone, so that a given force is turned into the
/// span in closed form.
class SlidingContact {
 public:
  /// The integral over the lines is made when it is first needed: BadInput "digits" where they do not give them.
  SlidingContact(SurfaceAnswer surface, const Indenter& body, const Exact& friction,
                 const HalfSpaceLoad& load, int digits, SpanRule rule = SpanRule::stationary_force);

  [[nodiscard]] Estimate span(const Exact& degrees) const;        ///< L(psi), unit of length
  [[nodiscard]] Estimate span_ratio(const Exact& degrees) const;  ///< L(psi)/L(0)
  [[nodiscard]] Estimate force() const;
  [[nodiscard]] Estimate friction_force() const;
  [[nodiscard]] Estimate peak_pressure() const;  ///< on the line along the motion, unit of stress
  [[nodiscard]] Estimate leading_end(const Exact& degrees) const;  ///< x+ = -Omega L, unit of length
  /// At x on a line; 0 outside of the contact. The error is that of the ends too.
  [[nodiscard]] Estimate pressure(const Exact& degrees, const Exact& x) const;
  /// First moment of the pressure over the force from the point of first touch, along the motion, and across it, 90
  /// degrees on; the error is relative to the span.
  [[nodiscard]] Estimate centre_along() const;
  [[nodiscard]] Estimate centre_across() const;

 private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

}  // namespace nipref::ref
