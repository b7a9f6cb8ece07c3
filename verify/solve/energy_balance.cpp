#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_bessel.h>

#include <complex>

#include <nipref/fast/material/functions.hpp>
#include <nipref/verify/solve/energy_balance.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

using Complex = std::complex<double>;

/// Sets j_0 .. j_n of x >= 0. Steed's method is exact where j_n underflows, but slow for large x.
void spherical_bessel(double x, std::vector<double>& j) {
  const int last = static_cast<int>(j.size()) - 1;
  if (x < 1000) {
    gsl_sf_bessel_jl_steed_array(last, x, j.data());
  } else {
    gsl_sf_bessel_jl_array(last, x, j.data());
  }
}

/// A part of the contact: sum c_l P_l(t), t from -1 to 1.
struct LossPanel {
  double middle, half;  ///< of y
  std::vector<double> coefficients;
};

/// The expansion of the pressure, with the integral of its error.
class ExpandedPressure {
 public:
  ExpandedPressure(double first, double last, const std::function<fast::Estimate(double)>& pressure,
                   int terms)
      : terms_(static_cast<std::size_t>(terms)), bessel_(terms_) {
    // The part of the load beyond the last halving is 2^{-60}, as the pressure is like a square root there.
    constexpr int halvings = 40;
    const double size = (last - first) / 2;
    for (const double side : {-1.0, 1.0}) {
      double outer = 0;  // from the middle
      for (int k = 1; k <= halvings; ++k) {
        const double next = size * (1 - std::ldexp(1, -k));
        const double middle = first + size + side * (outer + next) / 2;
        append(middle, (next - outer) / 2, pressure);
        outer = next;
      }
    }
  }

  /// The integral of the pressure's error over the contact.
  [[nodiscard]] double error() const { return error_; }
  [[nodiscard]] Complex transform(double q) {
    Complex sum = 0;
    for (const LossPanel& panel : panels_) {
      spherical_bessel(q * panel.half, bessel_);
      // (-i)^l has four values.
      double parts[4] = {0, 0, 0, 0};
      for (std::size_t l = 0; l < terms_; ++l) parts[l % 4] += panel.coefficients[l] * bessel_[l];
      sum +=
          std::polar(2 * panel.half, -q * panel.middle) * Complex(parts[0] - parts[2], parts[3] - parts[1]);
    }
    return sum;
  }

 private:
  void append(double middle, double half, const std::function<fast::Estimate(double)>& pressure) {
    LossPanel panel{middle, half, std::vector<double>(terms_)};
    gsl_integration_glfixed_table* rule = gsl_integration_glfixed_table_alloc(terms_);
    for (std::size_t i = 0; i < terms_; ++i) {
      double t = 0, weight = 0;
      gsl_integration_glfixed_point(-1, 1, i, &t, &weight, rule);
      const fast::Estimate here = pressure(middle + half * t);
      error_ += half * weight * here.error;
      double last = 0, now = 1;
      for (std::size_t l = 0; l < terms_; ++l) {
        const auto n = static_cast<double>(l);
        panel.coefficients[l] += (2 * n + 1) / 2 * weight * here.value * now;
        const double next = ((2 * n + 1) * t * now - n * last) / (n + 1);
        last = now, now = next;
      }
    }
    gsl_integration_glfixed_table_free(rule);
    panels_.push_back(std::move(panel));
  }

  std::size_t terms_;
  std::vector<double> bessel_;
  std::vector<LossPanel> panels_;
  double error_ = 0;
};

/// S(s) without cancellation.
double surface_symbol(double s) {
  const double fade = std::exp(-2 * s), rest = -std::expm1(-2 * s);
  return rest * rest / (-std::expm1(-4 * s) + 4 * s * fade);
}

struct Loss {
  double value = 0;
  /// The integral with |p^| in place of |p^|^2. Times twice the integral of the pressure's error it is the largest
  /// error that the pressure's error causes in the loss, to first order.
  double by_pressure = 0;
};

/// The weight of an octave centred at 1. It is analytic, and the weights of all octaves add up to 1.
double octave_share(double q) {
  constexpr double steepness = 3;
  const double octaves = std::log2(q);
  return (std::erf(steepness * (octaves + 0.5)) - std::erf(steepness * (octaves - 0.5))) / 2;
}
constexpr double octave_reach = 2.6;  ///< octaves beyond which the weight is below rounding

/// The step for the octave around q of an integrand that oscillates like e^{i q swing}.
double frequency_step(double q, double swing, int fineness) {
  const double smooth = q / fineness, half_swing = std::numbers::pi / swing;
  if (smooth <= half_swing) return smooth;
  const double odd = std::floor((smooth / half_swing - 1) / 2);
  return (2 * odd + 1) * half_swing;
}

Loss integral(const data::ViscoelasticNip& nip, const data::MaterialFunction& compliance, double length,
              ExpandedPressure& pressure, int fineness) {
  double lowest = std::min(1 / length, 1 / nip.half_thickness()), highest = 1 / length, swings = 1;
  for (const data::RelaxationTerm& term : compliance.terms) {
    // A material that flows loses energy at all low frequencies: with the margin, the part left out is below rounding.
    const bool flows = term.rate == 0.0;
    const double at = flows ? std::ldexp(lowest, -36) : std::abs(term.rate) / nip.speed;
    lowest = std::min(lowest, at), highest = std::max(highest, at);
    if (flows) continue;
    swings = std::max(swings, std::fabs(term.rate.imag()) / term.rate.real());
  }
  // The integrand grows like q^2 below these frequencies and falls like q^-4 above: the rest is below rounding.
  constexpr double margin = 0x1p18;
  Loss loss;
  for (double octave = lowest / margin; octave < highest * margin; octave *= 2) {
    const double step = frequency_step(octave, length, static_cast<int>(fineness * swings));
    const double last = octave * std::exp2(octave_reach);
    Loss here;
    for (double q = std::ceil(octave * std::exp2(-octave_reach) / step) * step; q < last; q += step) {
      const double transform = std::abs(pressure.transform(q));
      const double factor = step * octave_share(q / octave) * surface_symbol(q * nip.half_thickness()) *
                            -compliance.transform({0, q * nip.speed}).imag() / std::numbers::pi;
      here.value += factor * transform * transform;
      here.by_pressure += factor * transform;
    }
    loss.value += here.value, loss.by_pressure += here.by_pressure;
  }
  return loss;
}

fast::Estimate in_double(const fast::Estimate& number) { return number; }
/// The error includes rounding to double.
fast::Estimate in_double(const ref::Estimate& number) {
  const double value = number.to_double();
  return {value, static_cast<double>(error_of(number)) + 0x1p-53 * std::fabs(value)};
}

template <class Number>
EnergyBalance balance_of(const data::Scene& scene, const data::ViscoelasticNip& nip,
                         const SolvedContact<Number>& contact) {
  EnergyBalance balance;
  balance.warnings = beyond_theory(scene, contact);
  balance.work =
      in_double(contact.number(ResultId::load)) * in_double(contact.number(ResultId::rolling_resistance));
  const auto [first, last] = contact.ends();
  balance.loss =
      loss_integral(nip, first, last, [&](double y) { return in_double(contact.at(ResultId::pressure, y)); });
  return balance;
}

const data::ViscoelasticNipProblem& rolling_problem(const data::Scene& scene) {
  const auto* problem = std::get_if<data::ViscoelasticNipProblem>(&scene.system);
  if (problem == nullptr)
    scene.origin.refuse("rolling", "(missing)",
                        "must be there: only a sheet that rolls loses energy to its memory");
  if (!std::holds_alternative<data::ConvergedMethod>(problem->method))
    scene.origin.refuse("method.kind", "line-loads", "must be converged for a balance of energy");
  return *problem;
}

}  // namespace

fast::Estimate loss_integral(const data::ViscoelasticNip& nip, double first, double last,
                             const std::function<fast::Estimate(double y)>& pressure) {
  const data::MaterialFunction compliance = fast::material_functions(nip.material).normal_compliance();
  if (compliance.terms.empty()) return {0, 0};
  const double length = last - first;
  ExpandedPressure fine(first, last, pressure, 22), coarse(first, last, pressure, 17);
  const Loss loss = integral(nip, compliance, length, fine, 56);
  const Loss rough = integral(nip, compliance, length, coarse, 40);
  constexpr double rounding = 1e-14;
  return {loss.value, 2 * std::fabs(loss.value - rough.value) + 2 * fine.error() * loss.by_pressure +
                          rounding * loss.value};
}

EnergyBalance energy_balance(const data::Scene& scene, std::optional<int> digits) {
  scene.check();
  const data::ViscoelasticNipProblem& problem = rolling_problem(scene);
  auto [balance, seconds] = timed([&] {
    return digits ? balance_of(scene, problem.nip, *solved<RefPath>(scene, *digits))
                  : balance_of(scene, problem.nip, *solved<FastPath>(scene, scene.accuracy));
  });
  balance.title = scene.title;
  balance.seconds = seconds;
  return balance;
}

}  // namespace nipref::verify
