// The paper's rolling sphere: its integral equations, where it presses, what it refuses.
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>

#include "support/half_space.hpp"

using namespace nipref;
using fast::Direction;
using fast::rolling_sphere_for_force;
using fast::rolling_sphere_for_span;
using fast::RollingLine;

namespace {

/// A solid whose shear waves have speed 1.
const data::IsotropicSolid steel{2.5, 1. / 3, 2.5};
constexpr double sphere_radius = 4;

/// A point of an interval, with its distances to both ends to full relative accuracy.
struct IntervalPoint {
  double x, to_upper, to_lower;
};

/// (1/pi) vp int f(xi)/(xi - x) dxi over (lower, upper) for f that vanishes at the ends like a power. With xi = middle
/// + half tanh v the trapezoidal rule, whose nodes are half a step off the pole, converges geometrically.
double hilbert(double lower, double upper, double x, const std::function<double(IntervalPoint)>& f) {
  const double half = (upper - lower) / 2, middle = (upper + lower) / 2, step = 0.125;
  const double pole = std::atanh((x - middle) / half);
  double sum = 0;
  for (int node = -400; node < 400; ++node) {
    const double offset = (node + 0.5) * step, v = pole + offset;
    const double to_upper = 2 * half / (1 + std::exp(2 * v)), to_lower = 2 * half / (1 + std::exp(-2 * v));
    sum += f({middle + half * std::tanh(v), to_upper, to_lower}) * std::cosh(pole) /
           (std::cosh(v) * std::sinh(offset));
  }
  return sum * step / std::acos(-1.);
}

}  // namespace

TEST_CASE("rolling: the tractions give the slope and the stretch of the sphere on every line") {
  double worst = 0;
  for (const double speed : {0., 0.4, 0.8, 0.92}) {
    const auto contact = rolling_sphere_for_span(steel, sphere_radius, speed, 0.5);
    for (int i = 0; i < 25; ++i) {
      const Direction psi = Direction::of_angle(-1.5 + 0.13 * i);
      const RollingLine line = contact.along(psi);
      const double half = line.span / 2, x = half * (-0.97 + 1.94 * ((7 * i) % 25) / 24.);
      const fast::LineResponse answers = test::isotropic_line(steel.poisson, speed, psi);
      const double normal_compliance = answers.compliance, coupling = answers.coupling;
      // K_tt of the sagittal plane: X wS/R = (X wD/R) wS/wD.
      const double shear_compliance = normal_compliance / (line.shear_share * line.shear_share);
      const auto wave = [&](IntervalPoint at, double turn) {
        const double phase = line.index * std::log(at.to_upper / at.to_lower) + std::atan(at.x / line.lean);
        return line.amplitude * std::hypot(1, at.x / line.lean) * 2 * std::sqrt(at.to_upper * at.to_lower) *
               std::cos(phase - turn);
      };
      const double normal_transform = hilbert(-half, half, x, [&](IntervalPoint at) { return -wave(at, 0); });
      const double shear_transform = hilbert(-half, half, x, [&](IntervalPoint at) {
        return line.shear_share * wave(at, std::numbers::pi / 2);
      });
      const double slope = -normal_compliance * normal_transform - coupling * line.shear_traction(x).value;
      const double stretch = -shear_compliance * shear_transform + coupling * line.normal_traction(x).value;
      const double scale = half / sphere_radius * steel.shear;
      worst = std::fmax(worst, std::fabs(slope + steel.shear * x / sphere_radius) / scale);
      worst = std::fmax(
          worst, std::fabs(stretch -
                           steel.shear * (x * x / (2 * sphere_radius * sphere_radius) - line.creep.value)) /
                     scale);
    }
  }
  CHECK(worst < 5e-14);
}

TEST_CASE("rolling: the traction is compressive up to the compressed radius, and the force has an error") {
  const auto contact = rolling_sphere_for_span(steel, sphere_radius, 0.9, 1e-6);
  const RollingLine line = contact.along({1, 0});
  CHECK(line.normal_traction(line.compressed_radius().value * (1 - 1e-5)).value < 0);
  CHECK(line.normal_traction(line.compressed_radius().value * (1 + 1e-5)).value > 0);
  CHECK(contact.force().error > 0);  // at least the rounding error
}

TEST_CASE("rolling: bad input is refused") {
  CHECK_THROWS_AS(rolling_sphere_for_span(steel, sphere_radius, not_a_number, 0.1), data::BadInput);
  CHECK_THROWS_AS(rolling_sphere_for_span(steel, 0, 0.5, 0.1), data::BadInput);
  CHECK_THROWS_AS(rolling_sphere_for_span(steel, sphere_radius, 0.5, -0.1), data::BadInput);
  CHECK_THROWS_AS(rolling_sphere_for_force(steel, sphere_radius, 0.5, not_a_number), data::BadInput);
  CHECK_THROWS_AS(rolling_sphere_for_force({1, 0.5, 1}, sphere_radius, 0.5, 1), data::BadInput);
  const RollingLine line = rolling_sphere_for_span(steel, sphere_radius, 0.5, 0.1).along({1, 0});
  CHECK_THROWS_AS(static_cast<void>(line.shear_traction(not_a_number).value), data::BadInput);
  const double rayleigh = fast::isotropic_rayleigh_speed(0.3);
  CHECK_THROWS_AS(fast::separation_angle(0.3, rayleigh), data::BadInput);
  CHECK(fast::separation_angle(0.3, std::nextafter(rayleigh, 1)) < 2e-8);
}
