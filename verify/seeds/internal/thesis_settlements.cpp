#include <fmt/format.h>

#include <cmath>
#include <string>

#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/ref/memory/convolutions.hpp>
#include <nipref/ref/sheet/kernels.hpp>
#include <nipref/verify/seeds/internal/numerics.hpp>
#include <nipref/verify/seeds/internal/settled_row.hpp>
#include <nipref/verify/seeds/internal/settlements.hpp>
#include <nipref/verify/seeds/internal/thesis_nip.hpp>

namespace nipref::verify {
namespace {

/// sinh 2z + 2z
Propagated denominator(const Propagated& z) { return sinh(2 * z) + 2 * z; }

/// Where integrands that fall like e^-z are 0.
constexpr double far = 45;

/// What a material's own functions are rounded by: sums of a few products.
Propagated of_solid(double value) { return {value, 0x1p-48 * std::fabs(value)}; }

Propagated in_double(const ref::Enclosure& enclosure) { return SettledRow::in_double(enclosure); }

/// int_0^inf cos(xi y) ... of (3.25) on the loaded surface: both sides of G2(1, 1) = 0 from (4.14).
Settlement shear_stress_function() {
  const Propagated z = 1, d = denominator(z);
  const Propagated a = z * sinh(z) / (z * z * d), minus_d = cosh(z) / (z * z * d);
  const Propagated g = a * cosh(z) - minus_d * z * sinh(z);
  // d2G/dx2 is int sigma_y sin, over xi^2.
  const Propagated second = (a - 2 * minus_d) * cosh(z) - minus_d * z * sinh(z);
  return {"G2 b^2 on the surface, b xi = 1", -second, g, Propagated::exact(0)};
}

/// At eta = 0.7 with nu = 1/3: the terms of (4.6) and (4.8).
struct PinnedSheet {
  static constexpr const char* eta_text = "0.7";
  Propagated eta = 0.7, pi = Propagated::pi(), nu = 1 / Propagated(3);
  Propagated i4 = kernel("I4"), i5 = kernel("I5");

  static Propagated kernel(const char* name) { return SettledRow(name, {{"eta", eta_text}}).by_fast; }

  /// C2 E/(1 + nu) of (4.6): what pins the sheet under a normal load.
  [[nodiscard]] Propagated pinned() const {
    const auto integrand = [&](const Propagated& z) {
      if (z.value() == 0) return Propagated::exact(0);
      const Propagated a = (sinh(z) + z * cosh(z)) / denominator(z), d = -sinh(z) / denominator(z);
      return -2 / pi * (a + 2 * (1 - nu) * d) * sin(eta * z) / z;
    };
    return smooth_integral(integrand, 0, far);
  }
};

Settlement lost_pi() {
  const PinnedSheet sheet;
  const Propagated sum = sheet.i4 + sheet.i5, last = 2 * (1 - sheet.nu) / sheet.pi * sheet.i4;
  return {"the terms in eta of v_n E/(1 + nu), eta = 0.7, nu = 1/3", -sum + last, -sum / sheet.pi + last,
          sheet.pinned()};
}

Settlement one_factor_for_two_sums() {
  const PinnedSheet sheet;
  // theta1 = 1, theta2 = 1 - 2 nu in units of (1 + nu)/E; the sums are the integrals over pi without their limits 1/4.
  const Propagated theta1 = 1, theta2 = 1 - 2 * sheet.nu, both = theta1 + theta2;
  const Propagated fourth = sheet.i4 / sheet.pi - 0.25, fifth = sheet.i5 / sheet.pi - 0.25;
  const Propagated constant = -(theta1 - theta2) / (4 * both);
  return {"F1(0.7), nu = 1/3", theta2 / both * (fourth - fifth) + constant,
          (theta2 * fourth - theta1 * fifth) / both + constant, sheet.pinned() / both};
}

Settlement interchanged_functions() {
  const data::ViscoelasticMaterial solid = data::single_relaxation_time_solid(1, 3.0 / 8, 1);
  const Propagated printed = 4 / Propagated(9) * 1.5, at_once = 4 / Propagated(3);
  return {"theta1 K0 after a long time", printed, of_solid(solid.functions()->theta1.long_time()),
          2 * at_once};
}

Settlement rate_of_theta2() {
  constexpr double p = 1;  // over tau
  const Propagated share = (Propagated(p) + 1) / (Propagated(p) + 2), truth = 3 / (6 * share + 0.75 * share);
  const auto at = [&](const data::ViscoelasticMaterial& solid) {
    return of_solid(solid.functions()->theta2.transform(p).real());
  };
  return {"theta2 K0 at p = 1/tau", at(data::misprinted_thesis_solid(1, 3.0 / 8, 1)),
          at(data::single_relaxation_time_solid(1, 3.0 / 8, 1)), truth};
}

Settlement sign_of_rolling_creep() {
  const data::ElasticMaterial& sheet = data::seed::sheet_of_the_tables;
  const auto rolling =
      fast::converged_for_load({thesis_radius, 0.005, data::elastic_solid(sheet), 1}, 100, claims_accuracy);
  const Propagated length = rolling.contact_length();
  const Propagated leading = rolling.tangential_displacement(rolling.leading_length().value);
  const Propagated trailing = rolling.tangential_displacement(-rolling.trailing_length().value);
  return {"chi_0 without memory, B = 0.005 in, W = 100 lbf/in", (trailing - leading) / length,
          (leading - trailing) / length, thesis_nip(0.005, 100, data::Friction::none).creep_ratio()};
}

Settlement lost_exponential() {
  constexpr double alpha = 1;
  const auto symbol = [](const Propagated& x) {
    return x.value() == 0 ? Propagated(0.5) : 2 * sinh(x) * sinh(x) / (x * denominator(x));
  };
  // Beyond `end` the symbol is 1/x to rounding. Without the exponential the integral grows like a logarithm; with it
  // the rest is int_end^inf cos x/x dx = g(end) cos(end) - f(end) sin(end), by its auxiliary functions f and g.
  constexpr double end = 16;
  const auto cosine_rest = [](const Propagated& x) {
    return smooth_integral([&](const Propagated& t) { return exp(-x * t) * t / (1 + t * t); }, 0,
                           far / x.value());
  };
  const Propagated oscillating =
      smooth_integral([&](const Propagated& x) { return symbol(x) * cos(alpha * x); }, 0, end);
  const Propagated sine_part =
      smooth_integral([](const Propagated& t) { return exp(-end * t) / (1 + t * t); }, 0, far / end);
  const Propagated tail = cos(Propagated(end)) * cosine_rest(end) - sin(Propagated(end)) * sine_part;
  // What the symbol lacks of 1/x there: at most 2 (2 x + 1) e^-2x/x.
  const Propagated lacking(0, 5 * std::exp(-2 * end));
  return {"half of int H1 dx over |x| < 16, with the tail of cos x/x where there is one, alpha = 1",
          smooth_integral(symbol, 0, end), oscillating + tail + lacking,
          in_double(ref::I1(ref::Exact(alpha), 20))};
}

Settlement parts() {
  const Propagated k = 0.3, beta = 2, phi = 0.4, from = 0, to = 1;
  const auto sine = [=](const Propagated& t) { return exp(k * t) * sin(beta * (phi - t)); };
  const auto cosine = [=](const Propagated& t) { return exp(k * t) * cos(beta * (phi - t)); };
  const Propagated difference = (sine(to) - sine(from)) / beta, rest = k / beta * smooth_integral(sine, 0, 1);
  return {"J'' with K = 0.3, beta = 2, phi = 0.4 from 0 to 1", difference + rest, -difference + rest,
          smooth_integral(cosine, 0, 1)};
}

/// dv/dy under a shear load with the rotation C = 1 that the sheet may have besides, u = C y: v = -C x leaves it to
/// Hooke's law in plane strain, over theta1 + theta2 as v is.
Settlement rotation() {
  const auto in_the_sheet = [](const char* name, const std::string& alpha, Assignments more = {}) {
    more.insert(more.end(), {{"alpha", alpha}, {"depth", "0.5"}, {"load", "shear"}});
    return SettledRow(name, more);
  };
  const auto v = [&](double alpha) {
    return in_the_sheet("sheet.v", fmt::format("{}", alpha), {{"eta", "3"}, {"poisson", "0.25"}}).by_fast;
  };
  const Propagated slope = derivative(v, 0.75, 0.125);
  const Propagated across = in_the_sheet("sheet.sx", "0.75").by_ref,
                   along = in_the_sheet("sheet.sy", "0.75").by_ref;
  const Propagated truth = (along - across / 3) / 2;
  return {"dv/dy over theta1 + theta2 at alpha = 0.75, depth 0.5, with a rotation C = 1, nu = 1/4", slope - 1,
          slope, truth};
}

/// One residue A, B at a, b of (6.10) and one term e^-lambda t of the material, after the load has passed: what (6.19)
/// leaves for T < 0, B J4 - A J3. Phi and Psi of (6.21) are those that the last sum of (6.23) needs.
Settlement passed_load() {
  constexpr double rate = 3, a = 1.25, b = 2, t = 0.75, start = -0.5;
  constexpr double square_sum = (rate - a) * (rate - a) + b * b;
  const Propagated amplitude_a = 0.75, amplitude_b = 0.5;
  const Propagated phi = (amplitude_a * (rate - a) + amplitude_b * b) / square_sum;
  const Propagated psi = (amplitude_a * b - amplitude_b * (rate - a)) / square_sum;
  const Propagated late = exp(-a * (t - start)), early = exp(-rate * t + a * start);
  const Propagated angle = b * (t - start), first = b * start;
  const auto sum = [&](double sign) {
    return late * (phi * sin(angle) + sign * psi * cos(angle)) +
           early * (phi * sin(first) + psi * cos(first));
  };
  const auto by_ref = [&](const auto& convolution) {
    using ref::Exact;
    return in_double(convolution(Exact(rate), Exact(a), Exact(b), Exact(t), Exact(start), 20));
  };
  const Propagated truth = amplitude_b * by_ref(ref::J4) - amplitude_a * by_ref(ref::J3);
  return {"one residue's memory, lambda = 3, a = 1.25, b = 2, A = 0.75, B = 0.5, t = 0.75, T = -0.5", sum(1),
          sum(-1), truth};
}

/// The third of the four cases that are said to be drawn, against the first, which its caption repeats.
Settlement case_of_figure() {
  const auto case_at = [](const char* t0) {
    return SettledRow(
        "Vn", {{"t", "5"}, {"T", "4"}, {"t0", t0}, {"relaxation_time", "2"}, {"half_thickness", "1"}});
  };
  const SettledRow first = case_at("6"), third = case_at("-2");
  return {"Vn at t = 5, T = 4, F0 = b = 1, tau = 2, with t0 = 6 and t0 = -2", first.by_fast, third.by_fast,
          third.by_ref};
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
