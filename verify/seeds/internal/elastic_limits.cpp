#include <boost/math/quadrature/exp_sinh.hpp>

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/verify/seeds/internal/limit_rows.hpp>
#include <nipref/verify/seeds/internal/numerics.hpp>

namespace nipref::verify {
namespace {

using data::Friction;

constexpr double sheet_poisson = 1.0 / 3, elastic_accuracy = 1e-13;
const Propagated exact_poisson = Propagated::exact(sheet_poisson);

/// The solver's contact in the units of data/statements/limits.csv.
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

}  // namespace

LimitSamples elastic_limits() {
  const Propagated c = logarithm_constant(), kappa = edge_constant();
  const Propagated pi = Propagated::pi(), epsilon = log(3 - 4 * exact_poisson) / (2 * pi);
  const Propagated modulus = 2 * square(1 - exact_poisson) / (1 - 2 * exact_poisson);
  const auto film = [](double b) { return thin(b, Friction::full, 0.5); };
  return {
      {"limit.hertz.load",
       limit([](double a) { return thick(a).load(); }, [=](const Propagated& a) { return pi * square(a); })},
      {"limit.hertz.peak_pressure",
       limit([](double a) { return thick(a).peak_pressure(); }, [](const Propagated& a) { return 2 * a; })},
      {"limit.hertz.indentation",
       limit([](double a) { return thick(a).indentation(); },
             [=](const Propagated& a) { return square(a) * (log(2 / a) + 0.5 - c); })},
      {"limit.no_slip.creep", limit([](double a) { return thick(a, Friction::full).creep(); },
                                    [=](const Propagated& a) { return -4 * epsilon * a; })},
      {"limit.springs.load", limit([](double b) { return thin(b, Friction::none).load(); },
                                   [=](const Propagated& b) {
                                     const Propagated a = 1 / b;
                                     return 8 * a * a * (a / 3 + kappa);
                                   })},
      {"limit.springs.edge_displacement",
       limit([](double b) { return thin(b, Friction::none).edge_displacement(); },
             [=](const Propagated& b) { return 2 * kappa / b; })},
      {"limit.confined.load", limit([](double b) { return thin(b, Friction::full).load(); },
                                    [=](const Propagated& b) { return 4 * modulus / (3 * b * square(b)); })},
      {"limit.confined.shear",
       limit([](double b) { return thin(b, Friction::full).shear(0.5 / b); },
             [=](const Propagated& b) { return exact_poisson / (1 - exact_poisson) * (-modulus / b); })},
      {"limit.film.load", limit([=](double b) { return film(b).load(); },
                                [](const Propagated& b) { return 2 / (15 * pow(b, 5)); })},
      {"limit.film.peak_pressure", limit([=](double b) { return film(b).peak_pressure(); },
                                         [](const Propagated& b) { return 1 / (8 * square(square(b))); })},
  };
}

}  // namespace nipref::verify
