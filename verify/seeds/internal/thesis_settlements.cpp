#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>

#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/ref/memory/convolutions.hpp>
#include <nipref/ref/sheet/kernels.hpp>
#include <nipref/verify/seeds/internal/settled_row.hpp>
#include <nipref/verify/seeds/internal/settlements.hpp>
#include <nipref/verify/seeds/internal/thesis_nip.hpp>

namespace nipref::verify {
namespace {

using std::numbers::pi;

constexpr double one_third = 1.0 / 3;

double integral(const auto& integrand, double from, double to) {
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(integrand, from, to, 12, 1e-14);
}

/// sinh 2z + 2z
double denominator(double z) { return std::sinh(2 * z) + 2 * z; }

/// Where integrands that fall like e^-z are 0.
constexpr double far = 45;

/// int_0^inf cos(xi y) ... of (3.25) on the loaded surface: both sides of G2(1, 1) = 0 from (4.14).
Settlement shear_stress_function() {
  const double z = 1, d = denominator(z);
  const double a = z * std::sinh(z) / (z * z * d), minus_d = std::cosh(z) / (z * z * d);
  const double g = a * std::cosh(z) - minus_d * z * std::sinh(z);
  // d2G/dx2 is int sigma_y sin, over xi^2.
  const double second = (a - 2 * minus_d) * std::cosh(z) - minus_d * z * std::sinh(z);
  return {"G2 b^2 on the surface, b xi = 1", -second, g, 0, 1e-15};
}

/// C2 E/(1 + nu) of (4.6), at eta: what pins the sheet under a normal load.
double pinned(double eta) {
  const auto integrand = [eta](double z) {
    if (z == 0) return 0.0;
    const double a = (std::sinh(z) + z * std::cosh(z)) / denominator(z), d = -std::sinh(z) / denominator(z);
    return -2 / pi * (a + 2 * (1 - one_third) * d) * std::sin(eta * z) / z;
  };
  return integral(integrand, 0, far);
}

Settlement lost_pi() {
  constexpr double eta = 0.7;
  const double sum = fast::I4(eta) + fast::I5(eta), last = 2 * (1 - one_third) / pi * fast::I4(eta);
  return {"the terms in eta of v_n E/(1 + nu), eta = 0.7, nu = 1/3", -sum + last, -sum / pi + last,
          pinned(eta), 1e-13};
}

Settlement one_factor_for_two_sums() {
  constexpr double eta = 0.7;
  // theta1 = 1, theta2 = 1 - 2 nu in units of (1 + nu)/E; the sums are the integrals over pi without their limits 1/4.
  constexpr double theta1 = 1, theta2 = 1 - 2 * one_third, both = theta1 + theta2;
  const double fourth = fast::I4(eta) / pi - 0.25, fifth = fast::I5(eta) / pi - 0.25;
  const double constant = -(theta1 - theta2) / (4 * both);
  return {"F1(0.7), nu = 1/3", theta2 / both * (fourth - fifth) + constant,
          (theta2 * fourth - theta1 * fifth) / both + constant, pinned(eta) / both, 1e-13};
}

Settlement interchanged_functions() {
  const data::ViscoelasticMaterial solid = data::single_relaxation_time_solid(1, 3.0 / 8, 1);
  constexpr double printed = 4.0 / 9 * (1 + 0.5), at_once = 1 / (2 * 3.0 / 8);
  return {"theta1 K0 after a long time", printed, solid.theta1().long_time(), 2 * at_once, 1e-14};
}

Settlement rate_of_theta2() {
  constexpr double p = 1;  // over tau
  const double share = (p + 1) / (p + 2), truth = 3 / (6 * share + 2 * 3.0 / 8 * share);
  const auto at = [&](const data::ViscoelasticMaterial& solid) { return solid.theta2().transform(p).real(); };
  return {"theta2 K0 at p = 1/tau", at(data::misprinted_thesis_solid(1, 3.0 / 8, 1)),
          at(data::single_relaxation_time_solid(1, 3.0 / 8, 1)), truth, 1e-14};
}

Settlement sign_of_rolling_creep() {
  const data::ElasticMaterial& sheet = data::seed::sheet_of_the_tables;
  const auto rolling =
      fast::converged_for_load({thesis_radius, 0.005, data::elastic_solid(sheet), 1}, 100, claims_accuracy);
  const double length = rolling.contact_length().value;
  const double leading = rolling.tangential_displacement(rolling.leading_length().value).value;
  const double trailing = rolling.tangential_displacement(-rolling.trailing_length().value).value;
  const fast::Estimate truth = thesis_nip(0.005, 100, data::Friction::none).creep_ratio();
  return {"chi_0 without memory, B = 0.005 in, W = 100 lbf/in", (trailing - leading) / length,
          (leading - trailing) / length, truth.value, 1e-7 * truth.value};
}

Settlement lost_exponential() {
  constexpr double alpha = 1;
  const auto symbol = [](double x) {
    return x == 0 ? 0.5 : 2 * std::sinh(x) * std::sinh(x) / (x * denominator(x));
  };
  // Beyond `end` the symbol is 1/x to rounding. Without the exponential the integral grows like a logarithm; with it
  // the rest is int_end^inf cos x/x dx = g(end) cos(end) - f(end) sin(end), by its auxiliary functions f and g.
  constexpr double end = 16;
  const auto cosine_rest = [](double x) {
    return integral([x](double t) { return std::exp(-x * t) * t / (1 + t * t); }, 0, far / x);
  };
  const double oscillating = integral([&](double x) { return symbol(x) * std::cos(alpha * x); }, 0, end);
  const double sine_part = integral([](double t) { return std::exp(-end * t) / (1 + t * t); }, 0, far / end);
  const double tail = std::cos(end) * cosine_rest(end) - std::sin(end) * sine_part;
  const double without = integral(symbol, 0, end);
  const double truth = ref::I1(ref::Exact(alpha), 20).to_double();
  return {"half of int H1 dx over |x| < 16, with the tail of cos x/x where there is one, alpha = 1", without,
          oscillating + tail, truth, 1e-12};
}

Settlement parts() {
  constexpr double k = 0.3, beta = 2, phi = 0.4, from = 0, to = 1;
  const auto sine = [=](double t) { return std::exp(k * t) * std::sin(beta * (phi - t)); };
  const auto cosine = [=](double t) { return std::exp(k * t) * std::cos(beta * (phi - t)); };
  const double difference = (sine(to) - sine(from)) / beta, rest = k / beta * integral(sine, from, to);
  return {"J'' with K = 0.3, beta = 2, phi = 0.4 from 0 to 1", difference + rest, -difference + rest,
          integral(cosine, from, to), 1e-14};
}

/// dv/dy under a shear load with the rotation C = 1 that the sheet may have besides, u = C y: v = -C x leaves it to
/// Hooke's law in plane strain, over theta1 + theta2 as v is.
Settlement rotation() {
  const auto in_the_sheet = [](const char* name, const char* alpha, Assignments more = {}) {
    more.insert(more.end(), {{"alpha", alpha}, {"depth", "0.5"}, {"load", "shear"}});
    return SettledRow(name, more);
  };
  const auto v = [&](const char* alpha) {
    return in_the_sheet("sheet.v", alpha, {{"eta", "3"}, {"poisson", "0.25"}}).by_fast;
  };
  constexpr double poisson = 0.25, step = 0x1p-9;
  const double slope = (v("0.751953125") - v("0.748046875")) / (2 * step);
  const double across = in_the_sheet("sheet.sx", "0.75").by_ref,
               along = in_the_sheet("sheet.sy", "0.75").by_ref;
  const double truth = (along - poisson / (1 - poisson) * across) / 2;
  return {"dv/dy over theta1 + theta2 at alpha = 0.75, depth 0.5, with a rotation C = 1, nu = 1/4", slope - 1,
          slope, truth, 1e-5};
}

/// One residue A, B at a, b of (6.10) and one term e^-lambda t of the material, after the load has passed: what (6.19)
/// leaves for T < 0, B J4 - A J3. Phi and Psi of (6.21) are those that the last sum of (6.23) needs.
Settlement passed_load() {
  constexpr double rate = 3, a = 1.25, b = 2, amplitude_a = 0.75, amplitude_b = 0.5, t = 0.75, start = -0.5;
  constexpr double square = (rate - a) * (rate - a) + b * b;
  const double phi = (amplitude_a * (rate - a) + amplitude_b * b) / square;
  const double psi = (amplitude_a * b - amplitude_b * (rate - a)) / square;
  const double late = std::exp(-a * (t - start)), early = std::exp(-rate * t + a * start);
  const double angle = b * (t - start), first = b * start;
  const auto sum = [&](double sign) {
    return late * (phi * std::sin(angle) + sign * psi * std::cos(angle)) +
           early * (phi * std::sin(first) + psi * std::cos(first));
  };
  const auto by_ref = [&](const auto& convolution) {
    using ref::Exact;
    return convolution(Exact(rate), Exact(a), Exact(b), Exact(t), Exact(start), 20).to_double();
  };
  const double truth = amplitude_b * by_ref(ref::J4) - amplitude_a * by_ref(ref::J3);
  return {"one residue's memory, lambda = 3, a = 1.25, b = 2, A = 0.75, B = 0.5, t = 0.75, T = -0.5", sum(1),
          sum(-1), truth, 1e-15};
}

/// The third of the four cases that are said to be drawn, against the first, which its caption repeats.
Settlement case_of_figure() {
  const auto case_at = [](const char* t0) {
    return SettledRow("Vn", {{"t", "5"}, {"T", "4"}, {"t0", t0}, {"tau", "2"}, {"half_thickness", "1"}});
  };
  const SettledRow first = case_at("6"), third = case_at("-2");
  return {"Vn at t = 5, T = 4, F0 = b = 1, tau = 2, with t0 = 6 and t0 = -2", first.by_fast, third.by_fast,
          third.by_ref, third.promised};
}

}  // namespace

Settlements thesis_settlements() {
  return {{"thesis-3.25a", shear_stress_function},
          {"thesis-4.8", lost_pi},
          {"thesis-4.15b", rotation},
          {"thesis-4.24", one_factor_for_two_sums},
          {"thesis-6.25", passed_load},
          {"thesis-6.29", interchanged_functions},
          {"thesis-7.17", sign_of_rolling_creep},
          {"thesis-37", case_of_figure},
          {"thesis-AI.2", lost_exponential},
          {"thesis-AII.2", parts},
          {"thesis-AIII.15", rate_of_theta2}};
}

}  // namespace nipref::verify
