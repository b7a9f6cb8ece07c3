#include <cmath>
#include <numbers>
#include <string>

#include <nipref/verify/seeds/internal/principal_value.hpp>
#include <nipref/verify/seeds/internal/settlements.hpp>

namespace nipref::verify {
namespace {

using std::numbers::pi;

constexpr double rounding = 1e-12;

double over_all_lines(const auto& of_cosine) {
  return integral_between([&](double psi) { return of_cosine(std::cos(psi)); }, -pi / 2, pi / 2);
}

/// At (1/2, 0) in a hemisphere of pressure over the unit circle, at rest, mu = 1, where K = 1 - nu. Each line at psi
/// sees x = cos psi/2; printed, Cauchy's kernel in xi acts and eta is integrated out, which gives
/// -x - (1 - x^2) artanh x; right is the integral along eta at x itself, pi/2 (1 - x^2).
Settlement interchanged_kernels() {
  constexpr double compliance = 0.75, r = 0.5;
  const double printed = compliance / pi * over_all_lines([](double cosine) {
                           const double x = r * cosine;
                           return x + (1 - x * x) * std::atanh(x);
                         });
  const double right = compliance / (2 * pi) *
                       over_all_lines([](double cosine) { return pi / 2 * (1 - r * r * cosine * cosine); });
  return {"u3 at r = 1/2 under sqrt(1 - r^2), nu = 1/4, mu = 1", printed, right,
          pi * compliance * (2 - r * r) / 8, rounding};
}

/// The ellipse x1^2 + 4 x2^2 = 1, by its parameter.
Settlement span_of_ellipse() {
  const double psi = pi / 3, parameter = std::atan(2 * std::tan(psi));
  const double a = std::pow(std::cos(psi), 2) + 4 * std::pow(std::sin(psi), 2);
  return {"L/L1 at psi = 60 degrees, C2 = 4 C1", 1, 1 / std::sqrt(a),
          std::hypot(std::cos(parameter), std::sin(parameter) / 2), rounding};
}

/// Omega = -0.3 on -1 < t < 1, places in the region by t = cos angle, which keeps the distance to its ends.
struct Region {
  static constexpr double omega = -0.3, span = 2;
  static constexpr const char* place = ", Omega = -0.3, -1 < t < 1";

  /// |(x_+ - x)/(x - x_-)|^Omega
  static double weight(double x) { return std::pow(std::fabs((1 - x) / (1 + x)), omega); }

  /// What (B6) has before the weight for g = t^2, its second term times `factor`.
  static double polynomial(double x, double factor) {
    return x * x + factor * omega * (x + 1) - omega / 2 * (1 - omega) * span * span;
  }

  /// int g e^-w dt over the region
  static double integral(const auto& g) {
    return integral_between(
        [&](double angle) {
          return g(std::cos(angle)) * std::pow(std::tan(angle / 2), -2 * omega) * std::sin(angle);
        },
        0, pi);
  }
};

/// g cos + I(g; x) sin for g = t^2: t^2/(t - x) = t + x + x^2/(t - x), and the rest is the first of (B6).
Settlement squares_inside() {
  constexpr double x = 0.3;
  const double moment = Region::integral([](double t) { return t + x; });
  const double truth = Region::weight(x) * (x * x + std::sin(pi * Region::omega) / pi * moment);
  const auto form = [&](double factor) { return Region::polynomial(x, factor) * Region::weight(x); };
  return {std::string("g = t^2 at x = 0.3") + Region::place, form(1), form(Region::span), truth, rounding};
}

/// The right side of (B5) at x beyond the region.
double beyond(double x, const auto& g) {
  return Region::weight(x) / pi * Region::integral([&](double t) { return g(t) / (t - x); });
}

constexpr double outside = 1.5;

Settlement line_outside() {
  const double weight = Region::weight(outside), sine = std::sin(pi * Region::omega),
               shift = Region::omega * Region::span;
  return {std::string("g = t at x = 1.5") + Region::place, (outside * weight - outside - shift) / sine,
          ((outside + shift) * weight - outside) / sine, beyond(outside, [](double t) { return t; }),
          rounding};
}

Settlement squares_outside() {
  const double weight = Region::weight(outside), sine = std::sin(pi * Region::omega),
               square = outside * outside;
  return {std::string("g = t^2 at x = 1.5") + Region::place,
          (square * weight - Region::polynomial(outside, 1)) / sine,
          (Region::polynomial(outside, Region::span) * weight - square) / sine,
          beyond(outside, [](double t) { return t * t; }), rounding};
}

/// A sphere beside its lowest point, r0 = 1.
Settlement profile_of_sphere() {
  constexpr double x = 0x1p-20, y = 0x1p-20;
  const double square = x * x + y * y;
  return {"r0 - x3 of a sphere at X = Y = 2^-20 r0", x * x / 2, square / 2,
          square / (1 + std::sqrt(1 - square)), 1e-24};
}

/// x_1, x_2 of (16) turned back, theta = 0.
Settlement turned_back() {
  constexpr double xi = 0.5, eta = 0.25, psi = 1;
  const double c = std::cos(psi), s = std::sin(psi);
  // The X at which xi = X cos psi + x2 sin psi and eta = x2 cos psi - X sin psi, by Cramer's rule.
  const double truth = (xi * c - eta * s) / (c * c + s * s);
  return {"X at xi = 0.5, eta = 0.25, psi - theta = 1", xi * c + eta * s, xi * c - eta * s, truth, 1e-15};
}

/// (27) without friction, K = 1, mu0/r0 = 1, L = 2.
Settlement sign_of_pressure() {
  constexpr double x = 0.25;
  const auto half_circle = [](double t) { return std::sqrt((1 - t) * (1 + t)); };
  const double side = hilbert(half_circle, x, -1, 1);
  return {"left side of (27) at x = L/8, L = 2, mu0 = r0 = K = 1", side, -side, x, rounding};
}

}  // namespace

Settlements inversion_settlements() {
  return {{"brock2012-17", interchanged_kernels}, {"brock2012-30", span_of_ellipse},
          {"brock2012-B6", squares_inside},       {"brock2012-B7b", line_outside},
          {"brock2012-B7c", squares_outside},     {"brock2013-23", profile_of_sphere},
          {"brock2013-26b", turned_back},         {"brock2013-42", sign_of_pressure}};
}

}  // namespace nipref::verify
