#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/internal/half_turn_integral.hpp>
#include <nipref/fast/half_space/internal/isotropic_line.hpp>
#include <nipref/fast/half_space/internal/line_errors.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>
#include <nipref/fast/number/internal/checks.hpp>

namespace nipref::fast {

using data::BadInput;

namespace {

/// sum (-1)^j/(z + 2j) over j >= 0 for Re z > 0: the first terms, and the rest by Boole's summation formula. The first
/// term of the formula that is left out is 176896/|z|^12 < 2^-54.
std::complex<double> alternating_sum(std::complex<double> z) {
  constexpr int terms = 32;  // even; then |z| > 64
  std::complex<double> sum = 0;
  for (int j = 0; j < terms; j += 2) sum += 1. / (z + 2. * j) - 1. / (z + 2. * (j + 1));
  const std::complex<double> x = 1. / (z + 2. * terms), y = x * x;
  return sum + x / 2. + y * (0.5 + y * (-1. + y * (8. + y * (-136. + y * 3968.))));
}

/// int_0^1 t sqrt(1 - t^2) cos(P ln((1-t)/(1+t))) dt of (brock2012 54). Substitution of t = tanh v and integration by
/// parts lead to int_0^inf sin(2 P v)/cosh(v) dv, an alternating sum.
double oscillating_moment(double index) {
  const double a = 2 * index;
  const double sech_sine = 2 * alternating_sum({1, -a}).imag();
  return 1. / 3 - a / 6 * ((1 + a * a) * sech_sine - a);
}

/// A bound of the relative rounding errors of the properties of a line: 32 roundings of 2^-53. The root of a quotient of
/// rounded numbers has 2.5, a stiffness, a product of two roots, 6, a ratio of spans 13, a span over the radius 15. An
/// index has 17, most of them from the arguments of its logarithms. The product of index and span over radius would have
/// 33; it occurs in B alone, where RollingSphere::along adds six of the response.
constexpr double rounding = 32 * 0x1p-53;

}  // namespace

/// The properties of one line that do not depend on the load. X = c^2 cos^2 may be 0; therefore it is cancelled first.
struct RollingSphere::Shape {
  double slowness_ratio;  ///< sqrt(wS/wD)
  double index;           ///< P
  double rigidity;        ///< Q = sqrt(R/(1 - wS wD)), dimensionless

  [[nodiscard]] double stiffness() const { return slowness_ratio * rigidity; }
};

RollingSphere::RollingSphere(const data::IsotropicSolid& solid, double radius, double speed)
    : solid_(solid), radius_(radius), speed_(speed) {
  internal::check_positive("radius", radius);
  stiffness_along_ = shape({1, 0}).stiffness();
}

// With q = -N/sqrt(wS wD)/X and r = R/X, d = (1 - wS wD)/X: 1 - q^2 = r d/(wS wD), which vanishes at the
// Rayleigh speed and keeps its digits in this form.
RollingSphere::Shape RollingSphere::shape(Direction from_motion) const {
  const internal::IsotropicLine line = internal::isotropic_line(solid_, speed_, from_motion);
  const double shear_root = line.shear_decay.high, dilatation_root = line.pressure_decay.high;
  const double product = shear_root * dilatation_root, q = line.coupling.high / std::sqrt(product);
  const double rest = line.rayleigh.high * line.defect.high / product;
  const double twice_artanh = q < 0.5 ? 2 * std::atanh(q) : 2 * std::log1p(q) - std::log(rest);
  return {std::sqrt(shear_root / dilatation_root), twice_artanh / (2 * std::numbers::pi),
          std::sqrt(line.rayleigh.high / line.defect.high)};
}

// As the tractions oscillate, the terms of the moment grow like P^2 and cancel.
Estimate RollingSphere::force_factor() const {
  const auto terms = [&](Direction from_motion) {
    const Shape line = shape(from_motion);
    const double ratio = stiffness_along_ / line.stiffness(), weight = ratio * ratio;
    return std::array{weight * oscillating_moment(line.index), weight * (1 + line.index * line.index)};
  };
  const auto [moment, size] = half_turn_integral<2>(terms);
  const double factor = solid_.shear * stiffness_along_ / (4 * radius_);
  return {factor * moment.value, factor * (moment.error + rounding * size.value)};
}

Estimate RollingSphere::span_ratio(Direction from_motion) const {
  const double ratio = stiffness_along_ / shape(from_motion).stiffness();
  return {ratio, rounding * ratio};
}

Estimate RollingSphere::peak_pressure() const {
  const RollingLine line = along({1, 0});
  const double pressure = -line.normal_traction(0).value;
  // B is a difference, which magnifies relative errors.
  const double condition = 1 + 2 * line.index * line.span / line.lean;
  return {pressure, pressure * condition * (span_.error / span_.value + rounding)};
}

RollingLine RollingSphere::along(Direction from_motion) const {
  const Shape line = shape(from_motion);
  const double span = span_.value * stiffness_along_ / line.stiffness();
  const double relative = span / radius_;
  const double lean = line.slowness_ratio - line.index * relative / 2;  // B
  if (!(lean > 0)) throw BadInput("span", span, "must be small against the radius");
  const double uncertainty = span_.error / span_.value + rounding + internal::response_rounding;
  // The two terms of the creep may cancel, whereas their errors add. Span and index enter squared: twice the error of
  // each, 2 (15 + 17) roundings and twice that of the span alone.
  const double squared = 4 * line.index * line.index, of_wave = line.index * line.slowness_ratio;
  const Estimate creep{relative * (relative / 16 * (1 - squared) + of_wave),
                       3 * uncertainty * relative * (relative / 16 * (1 + squared) + of_wave)};
  return {span,
          line.index,
          2 * radius_ * lean,
          solid_.shear * lean * line.rigidity / (2 * radius_),
          1 / line.slowness_ratio,
          creep,
          uncertainty};
}

/// amplitude sqrt(L^2 - 4x^2)/cos(Phi) times cosine or sine of P ln((L-2x)/(L+2x)) + Phi. The error of the phase comes
/// from the distances to the ends; that of the factor comes from B = s - c B/2, c = P L/(r0 B), in the amplitude and again
/// in tan(Phi). Each time the relative error of B is 1 + c/2 times the uncertainty; with one more for other roundings the
/// factor is 3 + c.
Estimate RollingLine::traction(double x, Wave wave) const {
  internal::check_finite("x", x);
  const double half = span / 2, ahead = half - x, behind = half + x;
  const double distance_error = uncertainty * half + 0x1p-52 * std::fabs(x);
  const Estimate root = internal::between_ends(ahead, behind, distance_error,
                                               [](double a, double b) { return 2 * std::sqrt(a * b); });
  const double size = amplitude * (1 + std::fabs(x) / lean);
  if (root.value == 0) return {0, size * root.error};
  const double phase = index * std::log(ahead / behind), slope = x / lean;
  const double sine = std::sin(phase), cosine = std::cos(phase);
  const double turned = wave == Wave::cosine ? cosine - slope * sine : sine + slope * cosine;
  const double phase_error = index * (distance_error / ahead + distance_error / behind) +
                             index * uncertainty * (1 + std::fabs(std::log(ahead / behind)));
  const double relative = uncertainty * (3 + 2 * index * span / lean);
  return {amplitude * root.value * turned,
          size * (root.error + root.value * (std::min(2.0, phase_error) + relative))};
}

Estimate RollingLine::normal_traction(double x) const { return -1 * traction(x, Wave::cosine); }

Estimate RollingLine::shear_traction(double x) const {
  const Estimate along = traction(x, Wave::sine);
  return {shear_share * along.value, shear_share * along.error};
}

Estimate RollingLine::compressed_radius() const {
  const double radius = span / 2 * std::tanh(std::numbers::pi / (4 * index));
  return {radius, 2 * uncertainty * radius};
}

RollingSphere rolling_sphere_for_span(const data::IsotropicSolid& solid, double radius, double speed,
                                      double span) {
  internal::check_positive("span", span);
  RollingSphere contact(solid, radius, speed);
  contact.span_ = {span, 0};
  const auto [value, error] = contact.force_factor();
  contact.force_ = {value * span * span * span, error * span * span * span};
  return contact;
}

RollingSphere rolling_sphere_for_force(const data::IsotropicSolid& solid, double radius, double speed,
                                       double force) {
  internal::check_positive("force", force);
  RollingSphere contact(solid, radius, speed);
  const auto [value, error] = contact.force_factor();
  if (!(value > 0))
    throw BadInput("speed", speed, "must be farther below the Rayleigh speed: here the tractions pull");
  const double span = std::cbrt(force / value);
  contact.span_ = {span, span * (error / value / 3 + rounding)};
  contact.force_ = {force, 0};
  return contact;
}

// (1 + q)/(1 - q) is computed as (1 + q)^2/(1 - q^2), see RollingSphere::shape().
double rolling_strip(const data::IsotropicSolid& solid, double speed, Direction from_motion) {
  using internal::Two;
  constexpr Two pi{std::numbers::pi, 0x1.1a62633145c07p-53};
  const internal::IsotropicLine line = internal::isotropic_line(solid, speed, from_motion);
  const Two product = line.shear_decay * line.pressure_decay, q = line.coupling / sqrt(product);
  const Two rest = line.rayleigh * line.defect / product;
  const Two twice_artanh = log(square(Two{1} + q) / rest);
  if (!(twice_artanh.high > 0)) return 0;
  return decay(square(pi) / twice_artanh);
}

double separation_angle(double poisson, double speed) {
  const internal::Two rayleigh = internal::rayleigh_speed_in_two_words(poisson);
  const internal::Two above = internal::Two{speed} - rayleigh, sum = internal::Two{speed} + rayleigh;
  if (!(above.high >= 0 && speed <= 1)) {
    throw BadInput(
        "speed", speed,
        fmt::format("must be from {:.17g}, the Rayleigh speed, to 1, that of shear waves", rayleigh.high));
  }
  if (above.high == 0) return 0;
  return std::atan((sqrt(above * sum) / rayleigh).high);
}

}  // namespace nipref::fast
