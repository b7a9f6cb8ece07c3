#include <algorithm>
#include <array>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/internal/direction_words.hpp>
#include <nipref/fast/half_space/internal/half_turn_integral.hpp>
#include <nipref/fast/half_space/internal/line_errors.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/fast/number/internal/checks.hpp>

namespace nipref::fast {

using data::BadInput;

/// The properties of one line that do not depend on the load. leading = -Omega, trailing = 1 + Omega and
/// skew = 1 + 2 Omega are computed without cancellation.
struct SlidingContact::Shape {
  double leading, trailing, skew;
  double modulus;  ///< h = sqrt(K^2 + Gamma^2)
  double sine;     ///< sin(pi leading) = K/h
  double curvature;

  /// Q = (1+Omega)^(1+Omega) (-Omega)^(-Omega) (brock2012 33b)
  [[nodiscard]] double peak() const { return std::pow(trailing, trailing) * std::pow(leading, leading); }

  /// The ratio of peak pressure to span. By the papers' rule its product with the span is the same in all directions.
  [[nodiscard]] double steepness() const { return curvature * peak() / modulus; }

  struct Moments {
    double absolute, signed_square;
    double uncancelled;  ///< size of the terms whose difference is signed_square
  };

  /// The integrals int f |y| ds and int f y |y| ds over 0 < s < 1, f = (1-s)^trailing s^leading/Q, y = s - trailing.
  /// Integration by parts leaves one incomplete beta function, in D = int_(y<0) f ds - int_(y>0) f ds.
  [[nodiscard]] Moments moments() const {
    using namespace boost::math::policies;
    constexpr policy<promote_double<false>> in_double;
    const double total = leading * trailing * std::numbers::pi / (2 * sine * peak());
    const double difference =
        total * (2 * boost::math::ibeta(1 + leading, 1 + trailing, trailing, in_double) - 1);
    const double boundary = leading * trailing * std::pow(leading / trailing, skew);
    const double absolute = 2 * (skew * difference + boundary) / 3;
    return {absolute, -(leading * trailing * difference + 3 * skew * absolute) / 4,
            (leading * trailing * total + 3 * std::fabs(skew) * absolute) / 4};
  }
};

Estimate SlidingLine::pressure(double x) const {
  internal::check_finite("x", x);
  const double ahead = leading_end().value - x, behind = x - trailing_end().value;
  const double distance_error = uncertainty * span + 0x1p-52 * std::fabs(x);
  const Estimate shape = internal::between_ends(ahead, behind, distance_error, [&](double a, double b) {
    return std::pow(a / (trailing_share * span), trailing_share) *
           std::pow(b / (leading_share * span), leading_share);
  });
  const auto logarithm = [&](double distance) {
    return std::fabs(std::log(std::max(distance, distance_error) / span));
  };
  // The exponents add up to 1, so that the span counts once. A change of the shares counts with the logarithms of both
  // distances and of the shares' ratio, the latter as in rounding() less than once. 4 is an upper bound of the two.
  const double of_powers = uncertainty * (4 + logarithm(ahead) + logarithm(behind));
  return Estimate{peak_pressure, uncertainty * peak_pressure} *
         Estimate{shape.value, shape.error + shape.value * of_powers};
}

SlidingContact::SlidingContact(SurfaceResponse response, const Indenter& body, double friction,
                               Direction motion, SpanRule rule)
    : response_(std::move(response)), body_(body), friction_(friction), motion_(motion), rule_(rule) {
  body.check();
  if (!(friction >= 0 && friction <= 1000)) throw BadInput("friction", friction, "must be from 0 to 1000");
  internal::check_direction("motion", motion);
  steepness_ = shape(motion).steepness();
  integrate();
}

SlidingContact::Shape SlidingContact::shape(Direction psi) const {
  const LineResponse line = response_(psi);
  const double to_motion = psi.cosine * motion_.cosine + psi.sine * motion_.sine;
  const double to_motion_across = psi.cosine * motion_.sine - psi.sine * motion_.cosine;
  const auto of_friction = [&](double along, double across) {
    return friction_ * (to_motion * along + to_motion_across * across);
  };
  const double compliance =
      line.compliance + of_friction(line.shear_compliance, line.shear_compliance_across);
  if (!(compliance > 0) || !std::isfinite(compliance))
    throw BadInput("compliance", compliance,
                   "must be positive and finite: is the speed subcritical, the friction small?");
  for (const double each : {line.coupling, line.coupling_across}) internal::check_finite("coupling", each);
  const double shear = of_friction(line.coupling, line.coupling_across);
  const double modulus = std::hypot(compliance, shear);
  return {std::atan2(compliance, shear) / std::numbers::pi,
          std::atan2(compliance, -shear) / std::numbers::pi,
          2 * std::atan(shear / compliance) / std::numbers::pi,
          modulus,
          compliance / modulus,
          body_.curvature(psi)};
}

void SlidingContact::integrate() {
  const auto terms = [&](Direction from_motion) {
    const Shape line = shape(from_motion.turned(motion_));
    const auto [absolute, signed_square, uncancelled] = line.moments();
    const double ratio = span_ratio(line), peak = line.steepness() / steepness_ * ratio;
    const double cube = peak * ratio * ratio * ratio, moment = cube * signed_square,
                 size = cube * uncancelled;
    // The size is added to the moments, so that they are integrated to the rounding error of the size. The adaptive
    // integration would not end at the rounding error of the moments themselves, which may vanish.
    return std::array{peak * ratio * ratio * absolute, moment * from_motion.cosine + size,
                      moment * from_motion.sine + size, size};
  };
  const auto [force, lifted_along, lifted_across, uncancelled] = half_turn_integral<4>(terms);
  const Estimate along{lifted_along.value - uncancelled.value, lifted_along.error + uncancelled.error};
  const Estimate across{lifted_across.value - uncancelled.value, lifted_across.error + uncancelled.error};
  // The sum over the lines has the errors of its terms: in the force two span ratios and, with less than another, the
  // moments of a line; in a moment over the force, which is about half the span at most, seven ratios.
  const double rounded = rounding() * uncancelled.value / force.value;
  const auto over_force = [&](const Estimate& moment) {
    return Estimate{moment.value / force.value, moment.error / force.value + rounded + 4 * rounding()};
  };
  force_factor_ = {steepness_ * force.value, steepness_ * (force.error + 3 * rounding() * force.value)};
  moment_along_ = over_force(along);
  moment_across_ = over_force(across);
}

// In roundings u = 2^-53 there are 5 in a curvature, 8 in the peak of a line's pressure, 8 in its modulus, 6 of which are
// those of K, and two more in the steepness. Friction multiplies the couplings, whose products with the direction of the
// motion have errors of 17 u K together: 8.5 u in the modulus and 4.5 u in the peak, where 23 u/(1 + G^2) in the angle,
// G = Gamma/K, is multiplied by ln(leading/trailing)/pi. A span ratio has two steepnesses and a quotient.
double SlidingContact::rounding() const { return (47 + 26 * friction_) * 0x1p-53; }

void SlidingContact::set_span(Estimate span) {
  span_ = span;
  const auto scaled = [&](Estimate share) {
    return Estimate{share.value * span.value, share.error * span.value + std::fabs(share.value) * span.error};
  };
  centre_along_ = scaled(moment_along_);
  centre_across_ = scaled(moment_across_);
}

Estimate SlidingContact::peak_pressure() const {
  return {steepness_ * span_.value, steepness_ * (span_.error + rounding() * span_.value)};
}

Estimate SlidingContact::peak_pressure(Direction psi) const {
  const SlidingLine line = along(psi);
  return {line.peak_pressure, line.uncertainty * line.peak_pressure};
}

double SlidingContact::span_ratio(const Shape& line) const {
  if (rule_ == SpanRule::stationary_force) return steepness_ / line.steepness();
  return std::sqrt(body_.curvature(motion_) / line.curvature);
}

Estimate SlidingContact::span_ratio(Direction psi) const {
  const double ratio = span_ratio(shape(psi));
  return {ratio, rounding() * ratio};
}

SlidingLine SlidingContact::along(Direction psi) const {
  const Shape line = shape(psi);
  const double span = span_.value * span_ratio(line);
  return {line.leading, line.trailing, span, line.steepness() * span,
          span_.error / span_.value + rounding() + internal::response_rounding};
}

SlidingContact sliding_for_span(SurfaceResponse response, const Indenter& body, double friction,
                                Direction motion, double span, SpanRule rule) {
  internal::check_positive("span", span);
  SlidingContact contact(std::move(response), body, friction, motion, rule);
  contact.set_span({span, 0});
  const auto [value, error] = contact.force_factor_;
  contact.force_ = {value * span * span * span, error * span * span * span};
  return contact;
}

SlidingContact sliding_for_force(SurfaceResponse response, const Indenter& body, double friction,
                                 Direction motion, double force, SpanRule rule) {
  internal::check_positive("force", force);
  SlidingContact contact(std::move(response), body, friction, motion, rule);
  const auto [value, error] = contact.force_factor_;
  const double span = std::cbrt(force / value);
  contact.set_span({span, span * (error / value / 3 + contact.rounding())});
  contact.force_ = {force, 0};
  return contact;
}

}  // namespace nipref::fast
