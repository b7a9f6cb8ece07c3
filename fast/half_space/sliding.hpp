#pragma once
#include <nipref/fast/half_space/indenter.hpp>
#include <nipref/fast/half_space/response.hpp>
#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast {

/// The pressure -sigma33 on the line through the point of first touch in one direction. It is proportional to
/// (x+ - x)^(trailing_share) (x - x-)^(leading_share) for -trailing_share L < x < leading_share L, where L = span.
/// (brock2012 26a, 28; brock2013 28, 29a)
struct SlidingLine {
  double leading_share;   ///< -Omega = x+/L
  double trailing_share;  ///< 1 + Omega = -x-/L
  double span;            ///< L, unit of length
  double peak_pressure;   ///< at x = (leading_share - trailing_share) L, unit of stress
  double uncertainty;     ///< estimate of the error of span and peak pressure, relative

  [[nodiscard]] Estimate leading_end() const {  ///< x+, unit of length
    return {leading_share * span, uncertainty * span};
  }
  [[nodiscard]] Estimate trailing_end() const {  ///< x-, unit of length
    return {-trailing_share * span, uncertainty * span};
  }
  /// The pressure, unit of stress, 0 outside the contact. x must be finite, unit of length; otherwise BadInput.
  [[nodiscard]] Estimate pressure(double x) const;
};

/// The rule by which the spans of the lines are related.
enum class SpanRule {
  stationary_force,  ///< peak pressures are equal (brock2012 33)
  similar_contour    ///< like the body's contours, as the root of its radius of curvature (brock2012 30)
};

/// A rigid smooth body that slides with friction, as constructed in the papers: on every line through the point of
/// first touch K H[sigma33] + Gamma sigma33 = curvature x, Gamma = friction (S cos(psi - theta) - S' sin(psi - theta)),
/// where K, S and S' are the compliance and the couplings of that line. The papers lack S', which acts if the motion is
/// oblique to an axis in the surface, and the shear compliances, which friction adds to K if the surface is no plane of
/// symmetry. The spans either make the force stationary, so that the peak pressures of all lines are equal, or follow
/// the body's own contours. (brock2012 23-36, brock2013 27-36, their 1/Q^2 corrected to 1/Q^3.) This construction does
/// not solve the contact problem. Without friction, EllipticContact solves it; its force is 4/pi times the force of the
/// construction for the same span of a sphere at rest. The papers define no approach of the bodies.
class SlidingContact {
 public:
  [[nodiscard]] Estimate span() const { return span_; }    ///< L1, along the motion, unit of length
  [[nodiscard]] Estimate force() const { return force_; }  ///< F3, compressive
  /// The peak pressure on the line along the motion, unit of stress; with stationary_force the same in all directions.
  [[nodiscard]] Estimate peak_pressure() const;
  /// The first moment of the pressure divided by the force, from the point of first touch along the motion. It is <= 0
  /// for a positive coupling. Unit of length; the error is relative to the span.
  [[nodiscard]] Estimate centre_along() const { return centre_along_; }
  /// The first moment divided by the force across the motion, 90 degrees counterclockwise from it.
  [[nodiscard]] Estimate centre_across() const { return centre_across_; }
  [[nodiscard]] Estimate span_ratio(Direction psi) const;  ///< L(psi)/L1
  /// The peak pressure on the line in the direction psi, unit of stress.
  [[nodiscard]] Estimate peak_pressure(Direction psi) const;
  // Results on the line in the direction psi.
  [[nodiscard]] Estimate span(Direction psi) const { return span_ratio(psi) * span_; }  ///< L(psi)
  [[nodiscard]] Estimate leading_end(Direction psi) const { return along(psi).leading_end(); }
  [[nodiscard]] Estimate pressure(Direction psi, double x) const { return along(psi).pressure(x); }
  /// The line in the direction psi, of unit length; psi + 180 degrees is the same line with x reversed.
  [[nodiscard]] SlidingLine along(Direction psi) const;

 private:
  struct Shape;
  SlidingContact(SurfaceResponse response, const Indenter& body, double friction, Direction motion,
                 SpanRule rule);
  [[nodiscard]] Shape shape(Direction psi) const;
  [[nodiscard]] double span_ratio(const Shape& line) const;
  /// The relative rounding error of span ratios, which is that of K and S; friction magnifies it.
  [[nodiscard]] double rounding() const;
  void integrate();
  void set_span(Estimate span);

  SurfaceResponse response_;
  Indenter body_;
  double friction_;
  Direction motion_;
  SpanRule rule_;
  double steepness_;  ///< peak pressure over L1
  Estimate force_factor_{}, moment_along_{}, moment_across_{};
  Estimate span_{}, force_{}, centre_along_{}, centre_across_{};
  friend SlidingContact sliding_for_span(SurfaceResponse, const Indenter&, double, Direction, double,
                                         SpanRule);
  friend SlidingContact sliding_for_force(SurfaceResponse, const Indenter&, double, Direction, double,
                                          SpanRule);
};

/// The contact with span L1 along the motion, > 0 and finite, unit of length. friction is from 0 to 1000, motion is of
/// unit length, and the response in every direction must have a finite coupling and a positive finite compliance, as at
/// a subcritical speed; otherwise BadInput. The integral over the directions is exact to rounding if the response is
/// analytic; otherwise the error estimates include the truncation error.
SlidingContact sliding_for_span(SurfaceResponse response, const Indenter& body, double friction,
                                Direction motion, double span, SpanRule rule = SpanRule::stationary_force);

/// The contact that carries the force F3 > 0, finite; otherwise like sliding_for_span.
SlidingContact sliding_for_force(SurfaceResponse response, const Indenter& body, double friction,
                                 Direction motion, double force, SpanRule rule = SpanRule::stationary_force);

}  // namespace nipref::fast
