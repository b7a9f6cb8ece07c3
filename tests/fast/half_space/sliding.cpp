// The papers' sliding contact: its integral equation, its peak and centre, integrals over half a turn.
#include <nipref/fast/half_space/internal/half_turn_integral.hpp>
#include <nipref/fast/half_space/sliding.hpp>

#include "support/half_space.hpp"

using namespace nipref;
using fast::Direction;
using fast::Indenter;
using fast::sliding_for_force;
using fast::sliding_for_span;
using fast::SlidingLine;
using std::numbers::pi;
using test::any_poisson;
using test::isotropic;

namespace {

constexpr Direction along_x1{1, 0};
const Indenter die = Indenter::ellipsoid(0.7, 1.9, 1.3);

}  // namespace

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
    // The same line in the opposite direction.
    const SlidingLine back = contact.along(Direction::of_angle(0.3 * i + pi));
    CHECK(back.leading_end().value == doctest::Approx(-line.trailing_end().value).epsilon(1e-14));
    CHECK(back.pressure(-at).value == doctest::Approx(peak).epsilon(1e-13));
  }
}

TEST_CASE("sliding: without friction the centre is the point of first touch, next to a critical line too") {
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
    // The same peak in a direction at which no panel ends. The rounding error of the angle limits the accuracy.
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

TEST_CASE("integrals over half a turn have errors that cover a jump, and noise that no rule resolves") {
  const auto jump =
      fast::half_turn_integral<1>([](Direction psi) { return std::array{psi.sine > 0.1 ? 1. : 0.}; })[0];
  CHECK(std::fabs(jump.value - std::acos(0.1)) <= jump.error);
  CHECK(jump.error < 1e-12);
  const auto noisy = fast::half_turn_integral<1>(
      [](Direction psi) { return std::array{1 + 1e-9 * std::sin(1e9 * psi.sine)}; })[0];
  CHECK(std::fabs(noisy.value - pi) <= noisy.error);
  CHECK(noisy.error < 1e-7);
}

TEST_CASE("sliding: bad input is refused") {
  const auto response = isotropic(any_poisson, 0.5);
  CHECK_THROWS_AS(sliding_for_span(response, die, 0.1, along_x1, 0), data::BadInput);
  CHECK_THROWS_AS(sliding_for_span(response, die, 0.1, along_x1, not_a_number), data::BadInput);
  CHECK_THROWS_AS(sliding_for_force(response, die, 0.1, along_x1, -1), data::BadInput);
  CHECK_THROWS_AS(sliding_for_force(response, die, not_a_number, along_x1, 1), data::BadInput);
  CHECK_REFUSED(sliding_for_force(response, die, 1e300, along_x1, 1),
                "friction = 1e+300: must be from 0 to 1000");
  CHECK_THROWS_AS(sliding_for_force(response, {1, 0}, 0.1, along_x1, 1), data::BadInput);
  CHECK_THROWS_AS(sliding_for_force(response, die, 0.1, {1, 1}, 1), data::BadInput);
  CHECK_THROWS_AS(sliding_for_force(isotropic(any_poisson, 0.95), die, 0.1, along_x1, 1), data::BadInput);
  const auto line = sliding_for_span(response, die, 0.1, along_x1, 1).along(along_x1);
  CHECK_THROWS_AS(static_cast<void>(line.pressure(not_a_number).value), data::BadInput);
}
