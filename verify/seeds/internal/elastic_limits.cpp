#include <algorithm>
#include <boost/math/quadrature/exp_sinh.hpp>
#include <iterator>

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/verify/seeds/internal/limit_rows.hpp>
#include <nipref/verify/seeds/internal/numerics.hpp>

namespace nipref::verify {
namespace {

using data::Friction;

constexpr double sheet_poisson = 1.0 / 3, elastic_accuracy = 1e-13;
const Propagated exact_poisson = Propagated::exact(sheet_poisson);

// Of a sheet of half-thickness 1 on a contact of half-length A = L/B, with N = 2 (1 - nu^2)/E and rollers of radius R:
// pressure P = 2 N R p, load W likewise, indentation D = 2 R d0, creep X = 2 R chi.

/// The solver's contact in these numbers.
class UnitNip {
 public:
  UnitNip(double half_length, Friction friction, double nu)
      : nip_{radius * (1 + half_length), 2, {1, nu}},
        contact_(fast::converged_for_length(nip_, friction, 2 * half_length, elastic_accuracy)) {}

  [[nodiscard]] Propagated load() const { return stress() * contact_.load(); }
  [[nodiscard]] Propagated peak_pressure() const { return stress() * contact_.peak_pressure(); }
  [[nodiscard]] Propagated shear(double y) const { return stress() * contact_.shear(y); }
  [[nodiscard]] Propagated indentation() const { return length() * contact_.indentation(); }
  [[nodiscard]] Propagated edge_displacement() const { return length() * contact_.edge_displacement(); }
  [[nodiscard]] Propagated creep() const { return length() * contact_.creep_ratio(); }

 private:
  static constexpr double radius = 64;
  [[nodiscard]] Propagated length() const { return Propagated::exact(2 * nip_.roller_radius); }
  /// N = 2 (1 - nu^2), E being 1.
  [[nodiscard]] Propagated stress() const {
    return 2 * (1 - square(Propagated::exact(nip_.material.poisson))) * length();
  }

  data::ElasticNip nip_;
  fast::ConvergedElasticNip contact_;
};

UnitNip thick(double size, Friction friction = Friction::none) { return {size, friction, sheet_poisson}; }
UnitNip thin(double size, Friction friction, double nu = sheet_poisson) { return {1 / size, friction, nu}; }

/// int_0^inf f
Propagated half_line_integral(const auto& f) {
  boost::math::quadrature::exp_sinh<double> rule;
  return integral_by([&](const auto& g, auto... how) { return rule.integrate(g, how...); }, f);
}

/// c of I1(a) = -ln a - c + O(a^2): ln(pi/4) - int_0^inf [2 sinh^2 x/(sinh 2x + 2x) - tanh x]/x dx.
Propagated logarithm_constant() {
  const auto rest = [](const Propagated& x) {
    if (x.value() < 1e-9) return Propagated(-0.5, 1e-18);  // + x^2/3
    const Propagated e = exp(-2 * x), one_less = -expm1(-2 * x);
    const Propagated symbol = one_less * one_less / (-expm1(-4 * x) + 4 * x * e);
    return (symbol - tanh(x)) / x;
  };
  return log(Propagated::pi() / 4) - half_line_integral(rest);
}

/// kappa of thin springs: u = 2 A kappa at an end, (1/pi) int_0^inf -ln(2 G(z))/z^2 dz with G = 2 sinh^2 z/(z (sinh 2z +
/// 2z)), by Wiener and Hopf.
Propagated edge_constant() {
  const auto integrand = [](const Propagated& z) {
    // -ln(2 G) = z^4/45 - 4 z^6/945 + O(z^8)
    if (z.value() < 1e-2) {
      const Propagated z2 = z * z;
      return z2 / 45 - 4 * z2 * z2 / 945 + Propagated(0, (z2 * z2 * z2).value());
    }
    const Propagated sinh_square = square(-expm1(-2 * z));
    const Propagated denominator = z * (-expm1(-4 * z) / 2 + 2 * z * exp(-2 * z));
    return -log(sinh_square / denominator) / (z * z);
  };
  return half_line_integral(integrand) / Propagated::pi();
}

/// Orders: without friction what the half-space leaves out is even, I1(a) + ln a + c = O(a^2). Without slip I3 and the
/// like join, whose remainder is odd, O(a).
std::vector<LimitRow> thick_limits() {
  const Propagated c = logarithm_constant();
  const Propagated pi = Propagated::pi(), epsilon = log(3 - 4 * exact_poisson) / (2 * pi);
  constexpr auto size = "L/B";
  constexpr double first = 0.04;
  return {
      {"limit.hertz.load", "W = pi A^2", "Hertz's cylinder on a half-space", size, 2,
       halved(first,
              [pi](double a) {
                return LimitSample{a, thick(a).load(), pi * square(Propagated::exact(a))};
              })},
      {"limit.hertz.peak_pressure", "P(0) = 2 A", "Hertz's cylinder on a half-space", size, 2,
       halved(first,
              [](double a) {
                return LimitSample{a, thick(a).peak_pressure(), Propagated::exact(2 * a)};
              })},
      {"limit.hertz.indentation", "D = A^2 (ln(2/A) + 1/2 - c), I1(a) = -ln a - c + O(a^2)",
       "Hertz's cylinder, the sheet's logarithm by a double exponential rule", size, 2,
       halved(first,
              [c](double a) {
                const Propagated half = Propagated::exact(a);
                return LimitSample{a, thick(a).indentation(), square(half) * (log(2 / half) + 0.5 - c)};
              })},
      {"limit.no_slip.creep", "X = -4 eps A, eps = ln(3 - 4 nu)/(2 pi)",
       "the half-space without slip: solvability of its coupled equation", size, 1,
       halved(first / 16,
              [epsilon](double a) {
                return LimitSample{a, thick(a, Friction::full).creep(), -4 * epsilon * Propagated::exact(a)};
              })},
  };
}

std::vector<LimitRow> spring_limits() {
  const Propagated kappa = edge_constant(), modulus = 2 * square(1 - exact_poisson) / (1 - 2 * exact_poisson);
  constexpr auto size = "B/L";
  constexpr double first = 0.01;
  return {
      {"limit.springs.load", "W = 8 A^3/3 + 8 kappa A^2", "springs P = 2 u, ends by Wiener and Hopf", size, 2,
       halved(first,
              [kappa](double b) {
                const Propagated a = 1 / Propagated::exact(b);
                return LimitSample{b, thin(b, Friction::none).load(), 8 * a * a * (a / 3 + kappa)};
              })},
      {"limit.springs.edge_displacement", "u(A) = 2 A kappa", "ends of springs by Wiener and Hopf", size, 1,
       halved(first,
              [kappa](double b) {
                return LimitSample{b, thin(b, Friction::none).edge_displacement(),
                                   2 * kappa / Propagated::exact(b)};
              })},
      {"limit.confined.load", "W = (4/3) M A^3, M = 2 (1 - nu)^2/(1 - 2 nu)", "confined springs P = M u",
       size, 1,
       halved(first,
              [modulus](double b) {
                const Propagated thin_one = Propagated::exact(b);
                return LimitSample{b, thin(b, Friction::full).load(),
                                   4 * modulus / (3 * thin_one * square(thin_one))};
              })},
      {"limit.confined.shear", "Q(A/2) = nu/(1 - nu) P'(A/2), P' = -2 M y", "equilibrium of confined springs",
       size, 0,
       halved(0.0625,
              [modulus](double b) {
                const Propagated slope = -modulus / Propagated::exact(b);
                return LimitSample{b, thin(b, Friction::full).shear(0.5 / b),
                                   exact_poisson / (1 - exact_poisson) * slope};
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
                return LimitSample{b, film(b).load(), 2 / (15 * pow(Propagated::exact(b), 5))};
              })},
      {"limit.film.peak_pressure", "P(0) = A^4/8", source, size, 1,
       halved(
           first,
           [&](double b) {
             return LimitSample{b, film(b).peak_pressure(), 1 / (8 * square(square(Propagated::exact(b))))};
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
