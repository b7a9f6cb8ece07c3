#include <cmath>
#include <functional>
#include <string>

#include <nipref/verify/seeds/internal/numerics.hpp>
#include <nipref/verify/seeds/internal/settlements.hpp>

namespace nipref::verify {
namespace {

using Traction = std::function<Propagated(const Propagated& x)>;

/// The line at psi = 60 degrees of a sphere, r0 = 1, that rolls at c = 0.5 on nu = 1/3, mu = 1, with the span 0.25.
struct RollingLine {
  static constexpr double whole_span = 0.25, eighth = whole_span / 8;
  static constexpr const char* place = ", nu = 1/3, c = 0.5, psi = 60 degrees, L = 0.25 r0";

  Propagated span = whole_span, x = eighth;
  Propagated cx2 = 1.0 / 16, k = cx2 - 2;
  Propagated shear_root = sqrt(1 - cx2), dilatation_root = sqrt(1 - cx2 / 4);
  Propagated product = shear_root * dilatation_root;
  Propagated n = k + 2 * product, rayleigh = 4 * product - k * k,
             m = 2 * n + cx2;                                               // N, R, M of (16b) and (39b)
  Propagated index = atanh(-n / (sqrt(product) * cx2)) / Propagated::pi();  // P of (43b)
  Propagated root = sqrt(shear_root / dilatation_root);

  /// The normal and the shear traction of (49) along the line; `sign`: that of P in B, of Phi and of the shear.
  [[nodiscard]] Traction pressure(double sign) const { return traction(sign, cos, -1); }
  [[nodiscard]] Traction shear(double sign) const { return traction(sign, sin, sign / root); }

  /// The left sides of (38a) and of (38b, c) along the line, at x.
  [[nodiscard]] Propagated normal(double sign) const {
    return -cx2 * dilatation_root * transformed(pressure(sign)) + n * shear(sign)(x);
  }
  [[nodiscard]] Propagated tangential(double sign) const {
    return -n * pressure(sign)(x) + (m - rayleigh) / shear_root * transformed(shear(sign));
  }

  /// V0 from (38b, c) with the tractions that satisfy it.
  [[nodiscard]] Propagated creep() const { return x * x / 2 - tangential(+1) / rayleigh; }

 private:
  [[nodiscard]] Traction traction(double sign, Propagated (*wave)(const Propagated&),
                                  const Propagated& factor) const {
    const Propagated b = root - sign * index * span / 2, q = sqrt(rayleigh / (1 - product));
    return [=, *this](const Propagated& at) {
      if (std::fabs(at.value()) >= whole_span / 2) return Propagated::exact(0);
      // Printed: Phi = atan(x P/(2 B r0)), subtracted.
      const Propagated phase = atan(at * (sign < 0 ? index : 1) / (2 * b));
      const Propagated angle = index * log((span - 2 * at) / (span + 2 * at)) + sign * phase;
      return factor * b * q / (2 * cos(phase)) * sqrt((span - 2 * at) * (span + 2 * at)) * wave(angle);
    };
  }
  static Propagated transformed(const auto& f) { return hilbert(f, eighth, -whole_span / 2, whole_span / 2); }
};

std::string on_the_line(const char* what) { return std::string(what) + RollingLine::place; }

/// sin pi Omega and cos pi Omega over i of the exponent Omega = -1/2 - i P are -cosh pi P and -sinh pi P.
struct Exponent {
  Propagated sine, cosine_over_i;

  explicit Exponent(const RollingLine& line)
      : sine(-cosh(Propagated::pi() * line.index)), cosine_over_i(-sinh(Propagated::pi() * line.index)) {}
};

/// The first of (42a) times 1, the others along the line: what multiplies I(g; x) has to vanish.
Settlement shear_of_eigenfunction() {
  const RollingLine line;
  const Exponent exponent(line);
  const Propagated tangent = exponent.cosine_over_i / exponent.sine;
  return {on_the_line("Im H_+/g_+"),
          {},
          line.cx2 * line.dilatation_root * tangent / line.n,
          -line.n * line.shear_root / ((line.m - line.rayleigh) * tangent)};
}

/// g_+ for G3 = 1, G = 0 from the two equations that are left of (42a): g_- is its conjugate.
Settlement sign_of_eigenfunctions() {
  const RollingLine line;
  const Exponent exponent(line);
  const Propagated right = -sqrt(line.rayleigh / (1 - line.product)) * line.root / 2;
  const Propagated shear =
      line.cx2 * line.dilatation_root * exponent.cosine_over_i / (line.n * exponent.sine);
  // Two imaginary factors make the minus.
  const Propagated normal =
      line.cx2 * line.dilatation_root * exponent.sine - line.n * exponent.cosine_over_i * shear;
  return {on_the_line("g_+ for G3 = 1, G = 0"), -right, right, line.rayleigh / (2 * normal)};
}

/// V0 by (47b), x_+ = L/2, with its second term times `factor`.
Propagated creep_of(const RollingLine& line, const Propagated& factor) {
  return -factor * line.span * line.root + square(line.span) / 16 * (1 - 4 * square(line.index));
}

Settlement condition_of_creep() {
  const RollingLine line;
  return {on_the_line("V0 of (47b)"), creep_of(line, 1), creep_of(line, -line.index), line.creep()};
}

Settlement sign_of_line_creep() {
  const RollingLine line;
  return {on_the_line("V0 of (48)"), creep_of(line, line.index), creep_of(line, -line.index), line.creep()};
}

Settlement normal_traction() {
  const RollingLine line;
  return {on_the_line("left side of (38a) at x = L/8"), line.normal(-1), line.normal(+1),
          -line.rayleigh * line.x};
}

Settlement shear_traction() {
  const RollingLine line;
  const auto slope = [&](double sign) { return line.tangential(sign) / line.rayleigh; };
  return {on_the_line("G of (38b) at x = L/8"), slope(-1), slope(+1),
          square(line.x) / 2 - creep_of(line, -line.index)};
}

}  // namespace

Settlements rolling_line_settlements() {
  return {{"brock2012-44b", shear_of_eigenfunction}, {"brock2012-46", sign_of_eigenfunctions},
          {"brock2012-47b", condition_of_creep},     {"brock2012-48", sign_of_line_creep},
          {"brock2012-49a", normal_traction},        {"brock2012-49b", shear_traction}};
}

}  // namespace nipref::verify
