// The papers' sliding contact: its integral equation, its force, its contour, its limits.
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <nipref/fast/half_space/internal/half_turn_integral.hpp>
#include <nipref/fast/half_space/sliding.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>

#include "support/half_space.hpp"
#include "support/test.hpp"

using namespace nipref;
using fast::Direction;
using fast::Indenter;
using fast::sliding_for_force;
using fast::sliding_for_span;
using fast::SlidingContact;
using fast::SlidingLine;
using std::numbers::pi;
using test::any_poisson;
using test::isotropic;

namespace {

constexpr Direction along_x1{1, 0};
const Indenter die = Indenter::ellipsoid(0.7, 1.9, 1.3);

/// int p |x| dx and int p x |x| dx on one line.
std::array<double, 2> moments(const SlidingLine& line) {
  boost::math::quadrature::tanh_sinh<double> rule;
  const auto side = [&](double lower, double upper, double power) {
    return rule.integrate([&](double x) { return line.pressure(x).value * std::pow(std::fabs(x), power); },
                          lower, upper, 1e-13);
  };
  return {side(line.trailing_end().value, 0, 1) + side(0, line.leading_end().value, 1),
          side(0, line.leading_end().value, 2) - side(line.trailing_end().value, 0, 2)};
}

/// The resultants by brute force: Gauss-free, many directions.
std::array<double, 3> resultants(const SlidingContact& contact, Direction motion) {
  constexpr int directions = 40;
  std::array<double, 3> sum{};
  for (int i = 0; i < directions; ++i) {
    const double psi = pi * i / directions;
    const auto [force, moment] = moments(contact.along(Direction::of_angle(psi)));
    sum[0] += force * pi / directions;
    sum[1] += moment * pi / directions * (std::cos(psi) * motion.cosine + std::sin(psi) * motion.sine);
    sum[2] += moment * pi / directions * (std::sin(psi) * motion.cosine - std::cos(psi) * motion.sine);
  }
  return sum;
}

}  // namespace

TEST_CASE("sliding: the pressure satisfies the integral equation of every line") {
  const double friction = 0.4;
  const fast::SurfaceResponse response = [](Direction psi) {
    fast::LineResponse line = test::isotropic_line(any_poisson, 0.6, psi);
    line.coupling_across = 0.3 * psi.cosine * psi.sine;
    return line;
  };
  const auto contact = sliding_for_span(response, die, friction, along_x1, 0.3);
  double worst = 0;
  for (int i = 0; i < 100; ++i) {
    const Direction psi = Direction::of_angle(-1.5 + 0.03 * i);
    const SlidingLine line = contact.along(psi);
    const fast::LineResponse answers = response(psi);
    const double compliance = answers.compliance, coupling = answers.coupling,
                 coupling_across = answers.coupling_across;
    const double shear = psi.cosine * coupling - psi.sine * coupling_across;  // (1, 0) by line and across it
    const double x = line.trailing_end().value + line.span * (0.02 + 0.96 * ((37 * i) % 100) / 99.);
    // With the distances to the ends as they come, for the powers there.
    const double power = line.leading_share;
    const double scale = line.peak_pressure / (std::pow(line.trailing_share * line.span, 1 - power) *
                                               std::pow(power * line.span, power));
    const double transform =
        test::hilbert(line.trailing_end().value, line.leading_end().value, x, [&](test::IntervalPoint at) {
          return -scale * std::pow(at.to_upper, 1 - power) * std::pow(at.to_lower, power);
        });
    const double slope = die.curvature(psi) * x;  // K H[sigma] + Gamma sigma = slope (brock2012 23)
    const double found = compliance * transform - friction * shear * line.pressure(x).value;
    worst = std::fmax(worst, std::fabs(found - slope) / (die.curvature(psi) * line.span));
  }
  CHECK(worst < 2e-14);
}

TEST_CASE("sliding: force and centre of pressure against quadrature of the pressure") {
  for (const double friction : {0., 0.05, 0.5, 3.})
    for (const double angle : {0., 0.8, -2.5}) {
      const Direction motion = Direction::of_angle(angle);
      const auto contact = sliding_for_span(isotropic(0.2, 0.5), die, friction, motion, 0.4);
      const auto [force, along, across] = resultants(contact, motion);
      const auto close = [](fast::Estimate found, double truth, double scale) {
        CHECK(std::fabs(found.value - truth) < found.error + 1e-12 * scale);
        CHECK(found.error < 1e-13 * scale);
      };
      close(contact.force(), force, force);
      close(contact.centre_along(), along / force, 0.4);
      close(contact.centre_across(), across / force, 0.4);
      CHECK(contact.shear_force().value == friction * contact.force().value);
    }
}

TEST_CASE("sliding: span and force belong together, the force is cubic in the span") {
  const auto response = isotropic(0.1, 0.3);
  const auto contact = sliding_for_span(response, die, 0.3, along_x1, 0.2);
  const auto back = sliding_for_force(response, die, 0.3, along_x1, contact.force().value);
  CHECK(back.span().value == doctest::Approx(0.2).epsilon(1e-15));
  CHECK(back.span().error < 1e-14);
  CHECK(back.centre_along().value == approx(contact.centre_along().value, 1e-14));
  const auto twice = sliding_for_span(response, die, 0.3, along_x1, 0.4);
  CHECK(twice.force().value == doctest::Approx(8 * contact.force().value).epsilon(1e-15));
  CHECK(twice.peak_pressure().value == doctest::Approx(2 * contact.peak_pressure().value).epsilon(1e-15));
}

TEST_CASE("sliding: every line has the same peak, where the paper says") {
  const auto contact = sliding_for_span(isotropic(any_poisson, 0.7), die, 0.5, along_x1, 0.2);
  for (int i = 0; i < 20; ++i) {
    const SlidingLine line = contact.along(Direction::of_angle(0.3 * i));
    const double at = (line.leading_share - line.trailing_share) * line.span;  // (33a)
    const double peak = contact.peak_pressure().value;
    CHECK(line.pressure(at).value == doctest::Approx(peak).epsilon(1e-14));
    CHECK(line.pressure(at + 1e-3 * line.span).value < peak);
    CHECK(line.pressure(at - 1e-3 * line.span).value < peak);
    CHECK(line.pressure(line.leading_end().value * 1.001).value == 0);
    // The same line, run through backwards.
    const SlidingLine back = contact.along(Direction::of_angle(0.3 * i + pi));
    CHECK(back.leading_end().value == doctest::Approx(-line.trailing_end().value).epsilon(1e-14));
    CHECK(back.pressure(-at).value == doctest::Approx(peak).epsilon(1e-13));
  }
}

TEST_CASE("sliding: at rest without friction a sphere carries pi/4 of Hertz at the same span") {
  const double radius = 3, span = 0.1, a = span / 2;
  const auto contact =
      sliding_for_span(isotropic(any_poisson, 0), Indenter::sphere(radius), 0, along_x1, span);
  const double hertz = 8 * a * a * a / (3 * (1 - any_poisson) * radius);
  CHECK(contact.force().value == doctest::Approx(pi / 4 * hertz).epsilon(1e-14));
  CHECK(contact.span_ratio({0, 1}).value == doctest::Approx(1).epsilon(1e-15));
  CHECK(std::fabs(contact.centre_along().value) < 1e-16);
}

TEST_CASE(
    "sliding: without friction the centre is the point of first touch, to its error, next to a critical line too") {
  for (const double off : {1e-1, 1e-3, 1e-5}) {
    CAPTURE(off);
    const fast::SurfaceResponse response = [off](Direction psi) {
      const double along = psi.cosine * std::cos(0.3) - psi.sine * std::sin(0.3);
      return fast::LineResponse{1 / (1 + off - along * along), 0.2, 0.1};
    };
    const auto contact = sliding_for_span(response, die, 0, along_x1, 0.3);
    for (const fast::Estimate centre : {contact.centre_along(), contact.centre_across()})
      CHECK(std::fabs(centre.value) <= centre.error);
  }
}

TEST_CASE("sliding: an axis in the surface, oblique to the motion, and its mirror image") {
  const data::TransverselyIsotropicSolid solid{3.1, 20.7, 1.4, 1.9, 0.8, 1};
  const auto contact = [&](double theta) {
    const Direction motion = Direction::of_angle(theta);
    const auto surface = std::make_shared<const fast::TransverselyIsotropicHalfSpace>(
        solid, data::SymmetryAxis::in_plane, motion, 0.3);
    return sliding_for_span([surface](Direction psi) { return surface->along(psi); }, {1, 1}, 0.5, motion,
                            0.1);
  };
  const auto one = contact(0.5), image = contact(-0.5);
  CHECK(one.force().value == doctest::Approx(image.force().value).epsilon(1e-13));
  CHECK(one.centre_along().value == doctest::Approx(image.centre_along().value).epsilon(1e-12));
  CHECK(one.centre_across().value == doctest::Approx(-image.centre_across().value).epsilon(1e-12));
  // Along and across the axis nothing distinguishes the sides.
  for (const double theta : {0., pi / 2}) CHECK(std::fabs(contact(theta).centre_across().value) < 1e-15);
  CHECK(std::fabs(one.centre_across().value) > 1e-4);
}

TEST_CASE("sliding: table 1 of the first paper, first row, as far as friction matters there") {
  // The table leaves friction out of the last two factors (notes): 1e-3 at friction 0.1.
  constexpr std::array printed{0.9938, 0.9712, 0.9330, 0.8781, 0.8034, 0.7049};
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const double speed = 0.1 * static_cast<double>(i + 1);
    const auto contact =
        sliding_for_span(isotropic(any_poisson, speed), Indenter::sphere(1), 0.1, along_x1, 0.1);
    CHECK(contact.span_ratio({0, 1}).value == doctest::Approx(printed[i]).epsilon(2e-3));
  }
}

TEST_CASE("sliding: the contour of a die, by the closed form of the cross direction") {
  // (brock2012 35) corrected: C2 L2/(C1 L1) = K(90) h1^-1 Q1/Q(90), Q(90) = 1/2.
  const double friction = 0.3, speed = 0.5;
  const auto contact = sliding_for_span(isotropic(any_poisson, speed), die, friction, along_x1, 0.1);
  const fast::LineResponse line = isotropic(any_poisson, speed)(along_x1);
  const double compliance = line.compliance, coupling = line.coupling;
  const double gamma = friction * coupling, angle = std::atan(gamma / compliance) / pi;
  const double q = std::pow(0.5 + angle, 0.5 + angle) * std::pow(0.5 - angle, 0.5 - angle);
  CHECK(contact.span_ratio({0, 1}).value * 1.9 / 0.7 ==
        doctest::Approx((1 - any_poisson) / std::hypot(compliance, gamma) * 2 * q).epsilon(1e-14));
}

TEST_CASE("integrals over half a turn keep their digits at poles beside the directions") {
  for (const double gap : {1., 1e-4, 1e-8, 1e-16}) {
    const auto peaked = [gap](Direction psi) {
      const double c = psi.cosine * psi.cosine, s = psi.sine * psi.sine;
      return std::array{1 / (gap * c + s), psi.cosine * psi.sine / (gap * c + s)};
    };
    const auto [even, odd] = fast::half_turn_integral<2>(peaked);
    CHECK(even.value == approx(pi / std::sqrt(gap), 1e-13));
    CHECK(even.error < 1e-13 * even.value);
    CHECK(std::fabs(odd.value) <= odd.error);
    // The same peak where no panel ends: how well the angle is known limits it.
    const Direction off = Direction::of_angle(0.3);
    const auto turned = fast::half_turn_integral<1>([&](Direction psi) {
      const double c = psi.cosine * off.cosine + psi.sine * off.sine;
      const double s = psi.sine * off.cosine - psi.cosine * off.sine;
      return std::array{1 / (gap * c * c + s * s)};
    })[0];
    CHECK(std::fabs(turned.value - even.value) <= turned.error + even.error);
    CHECK(turned.error < 1e-15 / std::sqrt(gap) * turned.value + 1e-13 * turned.value);
  }
}

TEST_CASE("integrals over half a turn: a jump, and noise that no rule can see through") {
  const auto jump =
      fast::half_turn_integral<1>([](Direction psi) { return std::array{psi.sine > 0.1 ? 1. : 0.}; })[0];
  CHECK(std::fabs(jump.value - std::acos(0.1)) <= jump.error);
  CHECK(jump.error < 1e-12);
  const auto noisy = fast::half_turn_integral<1>(
      [](Direction psi) { return std::array{1 + 1e-9 * std::sin(1e9 * psi.sine)}; })[0];
  CHECK(std::fabs(noisy.value - pi) <= noisy.error);
  CHECK(noisy.error < 1e-7);
}

TEST_CASE("sliding: bad input is one line that names it") {
  const auto response = isotropic(any_poisson, 0.5);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(sliding_for_span(response, die, 0.1, along_x1, 0), data::BadInput);
  CHECK_THROWS_AS(sliding_for_span(response, die, 0.1, along_x1, nan), data::BadInput);
  CHECK_THROWS_AS(sliding_for_force(response, die, 0.1, along_x1, -1), data::BadInput);
  CHECK_THROWS_AS(sliding_for_force(response, die, nan, along_x1, 1), data::BadInput);
  CHECK_THROWS_WITH_AS(sliding_for_force(response, die, 1e300, along_x1, 1),
                       "friction = 1e+300: must be from 0 to 1000", data::BadInput);
  CHECK_THROWS_AS(sliding_for_force(response, {1, 0}, 0.1, along_x1, 1), data::BadInput);
  CHECK_THROWS_AS(sliding_for_force(response, die, 0.1, {1, 1}, 1), data::BadInput);
  CHECK_THROWS_AS(sliding_for_force(isotropic(any_poisson, 0.95), die, 0.1, along_x1, 1), data::BadInput);
  const auto line = sliding_for_span(response, die, 0.1, along_x1, 1).along(along_x1);
  CHECK_THROWS_AS(static_cast<void>(line.pressure(nan).value), data::BadInput);
}
