#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include <nipref/verify/seeds/internal/principal_value.hpp>
#include <nipref/verify/seeds/internal/settlements.hpp>

namespace nipref::verify {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;
using Traction = std::function<double(double x)>;

/// The line at psi = 60 degrees of a sphere, r0 = 1, that rolls at c = 0.5 on nu = 1/3, mu = 1, with the span 0.2.
struct RollingLine {
  static constexpr double span = 0.2, x = 0.025;
  static constexpr const char* place = ", nu = 1/3, c = 0.5, psi = 60 degrees, L = 0.2 r0";

  double cx2 = 1.0 / 16, k = cx2 - 2;
  double shear_root = std::sqrt(1 - cx2), dilatation_root = std::sqrt(1 - cx2 / 4);
  double product = shear_root * dilatation_root;
  double n = k + 2 * product, rayleigh = 4 * product - k * k, m = 2 * n + cx2;  // N, R, M of (16b) and (39b)
  double index = std::atanh(-n / (std::sqrt(product) * cx2)) / pi;              // P of (43b)
  double root = std::sqrt(shear_root / dilatation_root);

  /// The normal and the shear traction of (49) along the line; `sign`: that of P in B, of Phi and of the shear.
  [[nodiscard]] Traction pressure(double sign) const { return traction(sign, std::cos, -1); }
  [[nodiscard]] Traction shear(double sign) const { return traction(sign, std::sin, sign / root); }

  /// The left sides of (38a) and of (38b, c) along the line, at x.
  [[nodiscard]] double normal(double sign) const {
    return -cx2 * dilatation_root * transformed(pressure(sign)) + n * shear(sign)(x);
  }
  [[nodiscard]] double tangential(double sign) const {
    return -n * pressure(sign)(x) + (m - rayleigh) / shear_root * transformed(shear(sign));
  }

  /// V0 from (38b, c) with the tractions that satisfy it.
  [[nodiscard]] double creep() const { return x * x / 2 - tangential(+1) / rayleigh; }

 private:
  [[nodiscard]] Traction traction(double sign, double (*wave)(double), double factor) const {
    const double b = root - sign * index * span / 2, q = std::sqrt(rayleigh / (1 - product));
    return [=, *this](double at) {
      if (std::fabs(at) >= span / 2) return 0.0;
      // Printed: Phi = atan(x P/(2 B r0)), subtracted.
      const double phase = std::atan(at * (sign < 0 ? index : 1) / (2 * b));
      const double angle = index * std::log((span - 2 * at) / (span + 2 * at)) + sign * phase;
      return factor * b * q / (2 * std::cos(phase)) * std::sqrt((span - 2 * at) * (span + 2 * at)) *
             wave(angle);
    };
  }
  static double transformed(const auto& f) { return hilbert(f, x, -span / 2, span / 2); }
};

constexpr double quadrature_error = 1e-12;

std::string on_the_line(const char* what) { return std::string(what) + RollingLine::place; }

/// The first of (42a) times 1, the others along the line: what multiplies I(g; x) has to vanish.
Settlement shear_of_eigenfunction() {
  const RollingLine line;
  const Complex exponent{-0.5, -line.index}, sine = std::sin(pi * exponent), cosine = std::cos(pi * exponent);
  const Complex right = line.cx2 * line.dilatation_root * cosine / (line.n * sine);
  const Complex truth = line.n * line.shear_root * sine / ((line.m - line.rayleigh) * cosine);
  return {on_the_line("Im H_+/g_+"), {}, right.imag(), truth.imag(), quadrature_error};
}

/// g_+ for G3 = 1, G = 0 from the two equations that are left of (42a): g_- is its conjugate.
Settlement sign_of_eigenfunctions() {
  const RollingLine line;
  const double right = -std::sqrt(line.rayleigh / (1 - line.product)) * line.root / 2;
  const Complex exponent{-0.5, -line.index}, sine = std::sin(pi * exponent), cosine = std::cos(pi * exponent);
  const Complex shear = line.cx2 * line.dilatation_root * cosine / (line.n * sine);
  const Complex normal = line.cx2 * line.dilatation_root * sine + line.n * cosine * shear;
  return {on_the_line("g_+ for G3 = 1, G = 0"), -right, right, line.rayleigh / (2 * normal.real()),
          quadrature_error};
}

/// V0 by (47b), x_+ = L/2, with its second term times `factor`.
double creep_of(const RollingLine& line, double factor) {
  constexpr double span = RollingLine::span;
  return -factor * span * line.root + span * span / 16 * (1 - 4 * line.index * line.index);
}

Settlement condition_of_creep() {
  const RollingLine line;
  return {on_the_line("V0 of (47b)"), creep_of(line, 1), creep_of(line, -line.index), line.creep(),
          quadrature_error};
}

Settlement sign_of_line_creep() {
  const RollingLine line;
  return {on_the_line("V0 of (48)"), creep_of(line, line.index), creep_of(line, -line.index), line.creep(),
          quadrature_error};
}

Settlement normal_traction() {
  const RollingLine line;
  return {on_the_line("left side of (38a) at x = L/8"), line.normal(-1), line.normal(+1),
          -line.rayleigh * RollingLine::x, quadrature_error};
}

Settlement shear_traction() {
  const RollingLine line;
  const auto slope = [&](double sign) { return line.tangential(sign) / line.rayleigh; };
  const double x = RollingLine::x;
  return {on_the_line("G of (38b) at x = L/8"), slope(-1), slope(+1), x * x / 2 - creep_of(line, -line.index),
          quadrature_error};
}

}  // namespace

Settlements rolling_line_settlements() {
  return {{"brock2012-44b", shear_of_eigenfunction}, {"brock2012-46", sign_of_eigenfunctions},
          {"brock2012-47b", condition_of_creep},     {"brock2012-48", sign_of_line_creep},
          {"brock2012-49a", normal_traction},        {"brock2012-49b", shear_traction}};
}

}  // namespace nipref::verify
