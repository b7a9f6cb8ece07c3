#include <numbers>
#include <string>

#include <nipref/verify/seeds/internal/numerics.hpp>
#include <nipref/verify/seeds/internal/settlements.hpp>

namespace nipref::verify {
namespace {

Propagated over_all_lines(const auto& of_cosine) {
  constexpr double quarter = std::numbers::pi / 2;
  return integral_between([&](const Propagated& psi) { return of_cosine(cos(psi)); }, -quarter, quarter);
}

/// At (1/2, 0) in a hemisphere of pressure over the unit circle, at rest, mu = 1, where K = 1 - nu. Each line at psi
/// sees x = cos psi/2; printed, Cauchy's kernel in xi acts and eta is integrated out, which gives
/// -x - (1 - x^2) artanh x; right is the integral along eta at x itself, pi/2 (1 - x^2).
Settlement interchanged_kernels() {
  const Propagated compliance = 0.75, r = 0.5, pi = Propagated::pi();
  const Propagated printed = compliance / pi * over_all_lines([&](const Propagated& cosine) {
                               const Propagated x = r * cosine;
                               return x + (1 - x * x) * atanh(x);
                             });
  const Propagated right = compliance / (2 * pi) * over_all_lines([&](const Propagated& cosine) {
                             return pi / 2 * (1 - square(r * cosine));
                           });
  return {"u3 at r = 1/2 under sqrt(1 - r^2), nu = 1/4, mu = 1", printed, right,
          pi * compliance * (2 - r * r) / 8};
}

/// The ellipse x1^2 + 4 x2^2 = 1, by its parameter.
Settlement span_of_ellipse() {
  const Propagated psi = Propagated::pi() / 3, parameter = atan(2 * tan(psi));
  const Propagated a = square(cos(psi)) + 4 * square(sin(psi));
  return {"L/L1 at psi = 60 degrees, C2 = 4 C1", Propagated::exact(1), 1 / sqrt(a),
          hypot(cos(parameter), sin(parameter) / 2)};
}

/// Omega = -0.3 on -1 < t < 1, places in the region by t = cos angle, which keeps the distance to its ends.
struct Region {
  static constexpr const char* place = ", Omega = -0.3, -1 < t < 1";
  Propagated omega = -0.3, span = 2, pi = Propagated::pi();

  /// |(x_+ - x)/(x - x_-)|^Omega
  [[nodiscard]] Propagated weight(const Propagated& x) const { return pow(fabs((1 - x) / (1 + x)), omega); }

  /// What (B6) has before the weight for g = t^2, its second term times `factor`.
  [[nodiscard]] Propagated polynomial(const Propagated& x, const Propagated& factor) const {
    return x * x + factor * omega * (x + 1) - omega / 2 * (1 - omega) * span * span;
  }

  /// int g e^-w dt over the region
  [[nodiscard]] Propagated integral(const auto& g) const {
    return integral_between(
        [&](const Propagated& angle) { return g(cos(angle)) * pow(tan(angle / 2), -2 * omega) * sin(angle); },
        0, std::numbers::pi);
  }

  /// The right side of (B5) at x beyond the region.
  [[nodiscard]] Propagated beyond(const Propagated& x, const auto& g) const {
    return weight(x) / pi * integral([&](const Propagated& t) { return g(t) / (t - x); });
  }
};

/// g cos + I(g; x) sin for g = t^2: t^2/(t - x) = t + x + x^2/(t - x), and the rest is the first of (B6).
Settlement squares_inside() {
  const Region region;
  const Propagated x = 0.3;
  const Propagated moment = region.integral([&](const Propagated& t) { return t + x; });
  const Propagated truth = region.weight(x) * (x * x + sin(region.pi * region.omega) / region.pi * moment);
  const auto form = [&](const Propagated& factor) { return region.polynomial(x, factor) * region.weight(x); };
  return {std::string("g = t^2 at x = 0.3") + Region::place, form(1), form(region.span), truth};
}

constexpr double outside = 1.5;

Settlement line_outside() {
  const Region region;
  const Propagated x = outside, weight = region.weight(x), sine = sin(region.pi * region.omega),
                   shift = region.omega * region.span;
  return {std::string("g = t at x = 1.5") + Region::place, (x * weight - x - shift) / sine,
          ((x + shift) * weight - x) / sine, region.beyond(x, [](const Propagated& t) { return t; })};
}

Settlement squares_outside() {
  const Region region;
  const Propagated x = outside, weight = region.weight(x), sine = sin(region.pi * region.omega);
  return {std::string("g = t^2 at x = 1.5") + Region::place,
          (x * x * weight - region.polynomial(x, 1)) / sine,
          (region.polynomial(x, region.span) * weight - x * x) / sine,
          region.beyond(x, [](const Propagated& t) { return t * t; })};
}

/// A sphere beside its lowest point, r0 = 1.
Settlement profile_of_sphere() {
  const Propagated x = 0x1p-20, y = x, sum = x * x + y * y;
  // What the paraboloid leaves out: 1/8 of that square, and less.
  const Propagated left_out(0, square(sum).value() / 4);
  return {"r0 - x3 of a sphere at X = Y = 2^-20 r0", x * x / 2, sum / 2 + left_out,
          sum / (1 + sqrt(1 - sum))};
}

/// x_1, x_2 of (16) turned back, theta = 0.
Settlement turned_back() {
  const Propagated xi = 0.5, eta = 0.25, psi = 1, c = cos(psi), s = sin(psi);
  // The X at which xi = X cos psi + x2 sin psi and eta = x2 cos psi - X sin psi, by Cramer's rule.
  const Propagated truth = (xi * c - eta * s) / (c * c + s * s);
  return {"X at xi = 0.5, eta = 0.25, psi - theta = 1", xi * c + eta * s, xi * c - eta * s, truth};
}

/// (27) without friction, K = 1, mu0/r0 = 1, L = 2.
Settlement sign_of_pressure() {
  constexpr double x = 0.25;
  const auto half_circle = [](const Propagated& t) { return sqrt((1 - t) * (1 + t)); };
  const Propagated side = hilbert(half_circle, x, -1, 1);
  return {"left side of (27) at x = L/8, L = 2, mu0 = r0 = K = 1", side, -side, Propagated::exact(x)};
}

}  // namespace

Settlements inversion_settlements() {
  return {{"brock2012-17", interchanged_kernels}, {"brock2012-30", span_of_ellipse},
          {"brock2012-B6", squares_inside},       {"brock2012-B7b", line_outside},
          {"brock2012-B7c", squares_outside},     {"brock2013-23", profile_of_sphere},
          {"brock2013-26b", turned_back},         {"brock2013-42", sign_of_pressure}};
}

}  // namespace nipref::verify
