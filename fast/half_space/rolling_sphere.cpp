#include <fmt/format.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/half_space/internal/half_turn_integral.hpp>
#include <nipref/fast/half_space/internal/isotropic_line.hpp>
#include <nipref/fast/half_space/rolling_sphere.hpp>

namespace nipref::fast {

using data::BadInput;

namespace {

void check_positive(const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value)) throw BadInput(name, value, "must be positive and finite");
}

/// sum (-1)^j/(z + 2j), j >= 0, Re z > 0: terms until Boole's summation formula has converged to rounding.
std::complex<double> alternating_sum(std::complex<double> z) {
  constexpr int terms = 32;  // even; then |z| > 64
  std::complex<double> sum = 0;
  for (int j = 0; j < terms; j += 2) sum += 1. / (z + 2. * j) - 1. / (z + 2. * (j + 1));
  const std::complex<double> x = 1. / (z + 2. * terms), y = x * x;
  return sum + x / 2. + y * (0.5 + y * (-1. + y * (8. + y * (-136. + y * 3968.))));
}

/// int_0^1 t sqrt(1 - t^2) cos(P ln((1-t)/(1+t))) dt of (brock2012 54). With t = tanh v and by parts it needs
/// int_0^inf sin(2 P v)/cosh(v) dv, an alternating sum.
double oscillating_moment(double index) {
  const double a = 2 * index;
  const double sech_sine = 2 * alternating_sum({1, -a}).imag();
  return 1. / 3 - a / 6 * ((1 + a * a) * sech_sine - a);
}

}  // namespace

/// What one line has whatever the load. All quotients by X = c^2 cos^2 are formed first: X may be 0.
struct RollingSphere::Shape {
  double slowness_ratio;  ///< sqrt(wS/wD)
  double index;           ///< P
  double rigidity;        ///< Q = sqrt(R/(1 - wS wD)), dimensionless

  [[nodiscard]] double stiffness() const { return slowness_ratio * rigidity; }
};

RollingSphere::RollingSphere(const data::IsotropicSolid& solid, double radius, double speed)
    : solid_(solid), radius_(radius), speed_(speed) {
  check_positive("radius", radius);
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

// Where the tractions oscillate, the terms of a moment grow like P^2 and cancel.
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

double RollingSphere::span_ratio(Direction from_motion) const {
  return stiffness_along_ / shape(from_motion).stiffness();
}

ViscoelasticLine RollingSphere::along(Direction from_motion) const {
  const Shape line = shape(from_motion);
  const double span = span_.value * stiffness_along_ / line.stiffness();
  const double relative = span / radius_;
  const double lean = line.slowness_ratio - line.index * relative / 2;  // B
  if (!(lean > 0)) throw BadInput("span", span, "must be small against the radius");
  return {span,
          line.index,
          2 * radius_ * lean,
          solid_.shear * lean * line.rigidity / (2 * radius_),
          1 / line.slowness_ratio,
          relative * (relative / 16 * (1 - 4 * line.index * line.index) + line.index * line.slowness_ratio)};
}

namespace {

enum class Wave { cosine, sine };

/// sqrt(L^2 - 4x^2)/cos(Phi) times cosine or sine of P ln((L-2x)/(L+2x)) + Phi; 0 outside the contact.
double traction_wave(const ViscoelasticLine& line, double x, Wave wave) {
  if (!std::isfinite(x)) throw BadInput("x", x, "must be a finite number");
  const double ahead = line.span - 2 * x, behind = line.span + 2 * x;
  if (ahead <= 0 || behind <= 0) return 0;
  const double phase = line.index * std::log(ahead / behind), slope = x / line.lean;
  const double sine = std::sin(phase), cosine = std::cos(phase);
  return std::sqrt(ahead * behind) * (wave == Wave::cosine ? cosine - slope * sine : sine + slope * cosine);
}

}  // namespace

double ViscoelasticLine::normal_traction(double x) const {
  return -amplitude * traction_wave(*this, x, Wave::cosine);
}

double ViscoelasticLine::shear_traction(double x) const {
  return shear_share * amplitude * traction_wave(*this, x, Wave::sine);
}

double ViscoelasticLine::compressed_radius() const {
  return span / 2 * std::tanh(std::numbers::pi / (4 * index));
}

RollingSphere rolling_sphere_for_span(const data::IsotropicSolid& solid, double radius, double speed,
                                      double span) {
  check_positive("span", span);
  RollingSphere contact(solid, radius, speed);
  contact.span_ = {span, 0};
  const auto [value, error] = contact.force_factor();
  contact.force_ = {value * span * span * span, error * span * span * span};
  return contact;
}

RollingSphere rolling_sphere_for_force(const data::IsotropicSolid& solid, double radius, double speed,
                                       double force) {
  check_positive("force", force);
  RollingSphere contact(solid, radius, speed);
  const auto [value, error] = contact.force_factor();
  if (!(value > 0))
    throw BadInput("speed", speed, "must be farther below the Rayleigh speed: here the tractions pull");
  const double span = std::cbrt(force / value);
  contact.span_ = {span, span * (error / value / 3 + RollingSphere::rounding)};
  contact.force_ = {force, 0};
  return contact;
}

// 1 + q over 1 - q is (1 + q)^2 over 1 - q^2, see RollingSphere::shape().
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
