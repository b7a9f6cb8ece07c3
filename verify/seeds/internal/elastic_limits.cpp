#include <algorithm>
#include <boost/math/quadrature/exp_sinh.hpp>
#include <cmath>
#include <iterator>
#include <numbers>

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/verify/seeds/internal/limit_rows.hpp>

namespace nipref::verify {
namespace {

using data::Friction;
using std::numbers::pi;

constexpr double sheet_poisson = 1.0 / 3, elastic_accuracy = 1e-13;

// Of a sheet of half-thickness 1 on a contact of half-length A = L/B, with N = 2 (1 - nu^2)/E and rollers of radius R:
// pressure P = 2 N R p, load W likewise, indentation D = 2 R d0, creep X = 2 R chi.

/// The solver's contact in these numbers.
class UnitNip {
 public:
  UnitNip(double half_length, Friction friction, double nu)
      : nip_{radius * (1 + half_length), 2, {1, nu}},
        contact_(fast::converged_for_length(nip_, friction, 2 * half_length, elastic_accuracy)) {}

  [[nodiscard]] fast::Estimate load() const { return stress() * contact_.load(); }
  [[nodiscard]] fast::Estimate peak_pressure() const { return stress() * contact_.peak_pressure(); }
  [[nodiscard]] fast::Estimate shear(double y) const { return stress() * contact_.shear(y); }
  [[nodiscard]] fast::Estimate indentation() const { return length() * contact_.indentation(); }
  [[nodiscard]] fast::Estimate edge_displacement() const { return length() * contact_.edge_displacement(); }
  [[nodiscard]] fast::Estimate creep() const { return length() * contact_.creep_ratio(); }

 private:
  static constexpr double radius = 64;
  [[nodiscard]] double length() const { return 2 * nip_.roller_radius; }
  [[nodiscard]] double stress() const { return nip_.material.normal_compliance() * length(); }

  data::ElasticNip nip_;
  fast::ConvergedElasticNip contact_;
};

UnitNip thick(double size, Friction friction = Friction::none) { return {size, friction, sheet_poisson}; }
UnitNip thin(double size, Friction friction, double nu = sheet_poisson) { return {1 / size, friction, nu}; }

/// c of I1(a) = -ln a - c + O(a^2): ln(pi/4) - int_0^inf [2 sinh^2 x/(sinh 2x + 2x) - tanh x]/x dx.
double logarithm_constant() {
  boost::math::quadrature::exp_sinh<double> quadrature;
  const auto rest = [](double x) {
    if (x < 1e-3) return -0.5;  // + x^2/3, of which nothing remains in the integral
    const double e = std::exp(-2 * x), one_less = -std::expm1(-2 * x);
    const double symbol = one_less * one_less / (-std::expm1(-4 * x) + 4 * x * e);
    return (symbol - std::tanh(x)) / x;
  };
  return std::log(pi / 4) - quadrature.integrate(rest);
}

/// kappa of thin springs: u = 2 A kappa at an end, (1/pi) int_0^inf -ln(2 G(z))/z^2 dz with G = 2 sinh^2 z/(z (sinh 2z +
/// 2z)), by Wiener and Hopf.
double edge_constant() {
  boost::math::quadrature::exp_sinh<double> quadrature;
  const auto integrand = [](double z) {
    if (z < 1e-2) return z * z / 45;  // -ln(2 G) = z^4/45 + O(z^6)
    const double sinh_square = std::pow(-std::expm1(-2 * z), 2);
    const double denominator = z * (-std::expm1(-4 * z) / 2 + 2 * z * std::exp(-2 * z));
    return -std::log(sinh_square / denominator) / (z * z);
  };
  return quadrature.integrate(integrand) / pi;
}

/// Orders: without friction what the half-space leaves out is even, I1(a) + ln a + c = O(a^2). Without slip I3 and the
/// like join, whose remainder is odd, O(a).
std::vector<LimitRow> thick_limits() {
  const double c = logarithm_constant();
  const double epsilon = std::log(3 - 4 * sheet_poisson) / (2 * pi);
  constexpr auto size = "L/B";
  constexpr double first = 0.04;
  return {
      {"limit.hertz.load", "W = pi A^2", "Hertz's cylinder on a half-space", size, 2,
       halved(first,
              [](double a) {
                return LimitSample{a, thick(a).load(), pi * a * a};
              })},
      {"limit.hertz.peak_pressure", "P(0) = 2 A", "Hertz's cylinder on a half-space", size, 2,
       halved(first,
              [](double a) {
                return LimitSample{a, thick(a).peak_pressure(), 2 * a};
              })},
      {"limit.hertz.indentation", "D = A^2 (ln(2/A) + 1/2 - c), I1(a) = -ln a - c + O(a^2)",
       "Hertz's cylinder, the sheet's logarithm by a double exponential rule", size, 2,
       halved(first,
              [c](double a) {
                return LimitSample{a, thick(a).indentation(), a * a * (std::log(2 / a) + 0.5 - c)};
              })},
      {"limit.no_slip.creep", "X = -4 eps A, eps = ln(3 - 4 nu)/(2 pi)",
       "the half-space without slip: solvability of its coupled equation", size, 1,
       halved(first / 16,
              [epsilon](double a) {
                return LimitSample{a, thick(a, Friction::full).creep(), -4 * epsilon * a};
              })},
  };
}

std::vector<LimitRow> spring_limits() {
  const double kappa = edge_constant();
  constexpr double modulus = 2 * (1 - sheet_poisson) * (1 - sheet_poisson) / (1 - 2 * sheet_poisson);
  constexpr auto size = "B/L";
  constexpr double first = 0.01;
  return {
      {"limit.springs.load", "W = 8 A^3/3 + 8 kappa A^2", "springs P = 2 u, ends by Wiener and Hopf", size, 2,
       halved(first,
              [kappa](double b) {
                const double a = 1 / b;
                return LimitSample{b, thin(b, Friction::none).load(), 8 * a * a * (a / 3 + kappa)};
              })},
      {"limit.springs.edge_displacement", "u(A) = 2 A kappa", "ends of springs by Wiener and Hopf", size, 1,
       halved(first,
              [kappa](double b) {
                return LimitSample{b, thin(b, Friction::none).edge_displacement(), 2 * kappa / b};
              })},
      {"limit.confined.load", "W = (4/3) M A^3, M = 2 (1 - nu)^2/(1 - 2 nu)", "confined springs P = M u",
       size, 1,
       halved(first,
              [](double b) {
                return LimitSample{b, thin(b, Friction::full).load(), 4 * modulus / (3 * b * b * b)};
              })},
      {"limit.confined.shear", "Q(A/2) = nu/(1 - nu) P'(A/2), P' = -2 M y", "equilibrium of confined springs",
       size, 0,
       halved(0.0625,
              [](double b) {
                const double slope = -modulus / b;
                return LimitSample{b, thin(b, Friction::full).shear(0.5 / b),
                                   sheet_poisson / (1 - sheet_poisson) * slope};
              })},
  };
}

std::vector<LimitRow> film_limits() {
  const auto film = [](double size) { return thin(size, Friction::full, 0.5); };
  constexpr auto source = "a squeezed film: (2/3) P'' = X - D + y^2, P = P' = 0 at the ends";
  constexpr auto size = "B/L";
  constexpr double first = 0.005;
  return {
      {"limit.film.load", "W = 2 A^5/15", source, size, 1,
       halved(first,
              [&](double b) {
                return LimitSample{b, film(b).load(), 2 / (15 * std::pow(b, 5))};
              })},
      {"limit.film.peak_pressure", "P(0) = A^4/8", source, size, 1,
       halved(first,
              [&](double b) {
                return LimitSample{b, film(b).peak_pressure(), 1 / (8 * std::pow(b, 4))};
              })},
  };
}

}  // namespace

std::vector<LimitRow> elastic_limits() {
  std::vector<LimitRow> rows = thick_limits();
  for (auto* const more : {&spring_limits, &film_limits}) std::ranges::move(more(), std::back_inserter(rows));
  return rows;
}

}  // namespace nipref::verify
