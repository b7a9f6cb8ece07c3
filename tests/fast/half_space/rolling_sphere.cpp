// The paper's rolling sphere: its integral equations, its force, its contour, its limits.
#include <boost/math/quadrature/gauss.hpp>

#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>

#include "support/half_space.hpp"
#include "support/test.hpp"

using namespace nipref;
using fast::Direction;
using fast::rolling_sphere_for_force;
using fast::rolling_sphere_for_span;
using fast::RollingLine;
using std::numbers::pi;

namespace {

/// Of shear wave speed 1.
const data::IsotropicSolid steel{2.5, 1. / 3, 2.5};
constexpr double radius = 4;

}  // namespace

TEST_CASE("rolling: the tractions give the slope and the stretch of the sphere on every line") {
  double worst = 0;
  for (const double speed : {0., 0.4, 0.8, 0.92}) {
    const auto contact = rolling_sphere_for_span(steel, radius, speed, 0.5);
    for (int i = 0; i < 25; ++i) {
      const Direction psi = Direction::of_angle(-1.5 + 0.13 * i);
      const RollingLine line = contact.along(psi);
      const double half = line.span / 2, x = half * (-0.97 + 1.94 * ((7 * i) % 25) / 24.);
      const fast::LineResponse answers = test::isotropic_line(steel.poisson, speed, psi);
      const double normal_compliance = answers.compliance, coupling = answers.coupling;
      // K_tt of the sagittal plane: X wS/R = (X wD/R) wS/wD.
      const double shear_compliance = normal_compliance / (line.shear_share * line.shear_share);
      const auto wave = [&](test::IntervalPoint at, double turn) {
        const double phase = line.index * std::log(at.to_upper / at.to_lower) + std::atan(at.x / line.lean);
        return line.amplitude * std::hypot(1, at.x / line.lean) * 2 * std::sqrt(at.to_upper * at.to_lower) *
               std::cos(phase - turn);
      };
      const double normal_transform =
          test::hilbert(-half, half, x, [&](test::IntervalPoint at) { return -wave(at, 0); });
      const double shear_transform = test::hilbert(
          -half, half, x, [&](test::IntervalPoint at) { return line.shear_share * wave(at, pi / 2); });
      const double slope = -normal_compliance * normal_transform - coupling * line.shear_traction(x).value;
      const double stretch = -shear_compliance * shear_transform + coupling * line.normal_traction(x).value;
      const double scale = half / radius * steel.shear;
      worst = std::fmax(worst, std::fabs(slope + steel.shear * x / radius) / scale);
      worst = std::fmax(
          worst,
          std::fabs(stretch - steel.shear * (x * x / (2 * radius * radius) - line.creep.value)) / scale);
    }
  }
  CHECK(worst < 5e-14);
}

TEST_CASE("rolling: the force against quadrature of the normal traction") {
  // Small against the radius, as the force is of first order in L/r0.
  for (const double speed : {0., 0.5, 0.9}) {
    const auto contact = rolling_sphere_for_span(steel, radius, speed, 1e-9 * radius);
    constexpr int directions = 128;
    double force = 0;
    for (int i = 0; i < directions; ++i) {
      const RollingLine line = contact.along(Direction::of_angle(pi * i / directions));
      const auto integrand = [&](double v) {  // x = L/2 tanh v counts the oscillations
        const double x = line.span / 2 * std::tanh(v);
        return -line.normal_traction(x).value * x * line.span / 2 / std::pow(std::cosh(v), 2);
      };
      for (int panel = 0; panel < 20; ++panel)
        force += 2 * pi / directions *
                 boost::math::quadrature::gauss<double, 20>::integrate(integrand, panel, panel + 1);
    }
    CHECK(contact.force().value == approx(force, 3e-9));
    CHECK(contact.force().error < 1e-13 * force);
  }
}

TEST_CASE("rolling: span and force belong together, the force is cubic in the span") {
  const auto contact = rolling_sphere_for_span(steel, radius, 0.5, 0.1);
  const auto back = rolling_sphere_for_force(steel, radius, 0.5, contact.force().value);
  CHECK(back.span().value == doctest::Approx(0.1).epsilon(1e-15));
  const auto twice = rolling_sphere_for_span(steel, radius, 0.5, 0.2);
  CHECK(twice.force().value == approx(8 * contact.force().value, 1e-15));
}

TEST_CASE("rolling: table 2") {
  constexpr std::array printed{0.994, 0.9733, 0.9384, 0.8882, 0.8204, 0.7318};
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const auto contact = rolling_sphere_for_span(steel, radius, 0.1 * static_cast<double>(i + 1), 0.1);
    CHECK(std::fabs(contact.span_ratio({0, 1}).value - printed[i]) < 8e-4);
  }
  CHECK(rolling_sphere_for_span(steel, radius, 0, 0.1).span_ratio({0.6, 0.8}).value == doctest::Approx(1));
}

TEST_CASE("rolling: almost incompressible at rest the shear vanishes and the sliding force remains") {
  const data::IsotropicSolid rubber{1, 0.5 - 1e-12, 1};
  const auto contact = rolling_sphere_for_span(rubber, radius, 0, 0.1);
  const double hertz = 8 * std::pow(0.05, 3) / (3 * 0.5 * radius);
  CHECK(contact.force().value == approx(pi / 4 * hertz, 1e-11));
  const RollingLine line = contact.along({1, 0});
  CHECK(std::fabs(line.shear_traction(0.03).value) < 0.02 * std::fabs(line.normal_traction(0.03).value));
  CHECK(line.compressed_radius().value == line.span / 2);
}

TEST_CASE("rolling: compressive up to the compressed radius, the strip of the notes") {
  const auto contact = rolling_sphere_for_span(steel, radius, 0.9, 1e-6);
  const RollingLine line = contact.along({1, 0});
  CHECK(line.normal_traction(line.compressed_radius().value * (1 - 1e-5)).value < 0);
  CHECK(line.normal_traction(line.compressed_radius().value * (1 + 1e-5)).value > 0);
  const auto strip = [](double speed) {
    const double found = fast::rolling_strip(steel, speed, {1, 0});
    const double index = rolling_sphere_for_span(steel, radius, speed, 0.1).along({1, 0}).index;
    CHECK(found == approx(std::exp(-pi / 2 / index), 1e-13));
    return found;
  };
  CHECK(strip(0.3) == approx(2.0e-8, 0.03));
  CHECK(strip(0.6) == approx(2.2e-6, 0.03));
  CHECK(strip(0.8) == approx(3.3e-4, 0.03));
}

TEST_CASE("rolling: the angle of separation beyond the Rayleigh speed") {
  // c_R = 0.932 is that of nu = 0.32999.
  double low = 0.3, high = 0.35;
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    (fast::isotropic_rayleigh_speed(middle) < 0.932 ? low : high) = middle;
  }
  CHECK(fast::separation_angle(low, 1) * 180 / pi == doctest::Approx(21.25124).epsilon(2.5e-7));
  const double rayleigh = fast::isotropic_rayleigh_speed(0.3);
  CHECK_THROWS_AS(fast::separation_angle(0.3, rayleigh), data::BadInput);
  CHECK(fast::separation_angle(0.3, std::nextafter(rayleigh, 1)) < 2e-8);
  CHECK_THROWS_AS(fast::separation_angle(0.3, 1.0001), data::BadInput);
}

TEST_CASE("rolling: bad input is one line that names it") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(rolling_sphere_for_span(steel, radius, 0.94, 0.1), data::BadInput);
  CHECK_THROWS_AS(rolling_sphere_for_span(steel, radius, nan, 0.1), data::BadInput);
  CHECK_THROWS_AS(rolling_sphere_for_span(steel, 0, 0.5, 0.1), data::BadInput);
  CHECK_THROWS_AS(rolling_sphere_for_span(steel, radius, 0.5, -0.1), data::BadInput);
  CHECK_THROWS_AS(rolling_sphere_for_force(steel, radius, 0.5, nan), data::BadInput);
  CHECK_THROWS_AS(rolling_sphere_for_force({1, 0.5, 1}, radius, 0.5, 1), data::BadInput);
  const RollingLine line = rolling_sphere_for_span(steel, radius, 0.5, 0.1).along({1, 0});
  CHECK_THROWS_AS(static_cast<void>(line.shear_traction(nan).value), data::BadInput);
}
