// Viscoelastic nips in steady frictionless rolling, dimensionless.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/ref/viscoelastic_nip/converged.hpp>
#include <nipref/verify/catalogue/internal/nip_entry.hpp>

namespace nipref::verify {
namespace {

using NipArguments = std::span<const double>;

/// How often the kernel's rounding counts: at a distance of L it is about ln(1 + B/L), and pressure that the sheet gave way
/// to later is as much larger. Measured on random contacts errors are so, from one end of the domain to the other.
double amplification(NipArguments x) { return 1 + x[3] * std::log1p(1 / x[0]); }

constexpr std::array<NipNumber, 5> rolling_numbers{{
    {"rolling_nip.resistance",
     "(R/L) times the coefficient of rolling resistance, int p Y dY/(W L): the eccentricity of the load over "
     "the contact; 0 as the memory grows or shrinks beyond the contact",
     "1/10 or the value, times 1 + softening ln(1 + B/L)", 4096},
    {"rolling_nip.leading_share",
     "L1/L, the share of the contact ahead of the line through the rollers' centres",
     "the value, times 1 + softening ln(1 + B/L)", 4096},
    {"rolling_nip.load", "N R W/L^2 with N at once, 2(1 - poisson^2)/young; of nip.load as the memory grows",
     "the value, times 1 + softening ln(1 + B/L)", 4096},
    {"rolling_nip.indentation", "R d0/L^2; as L/B -> infinity between 1/8 and leading_share^2/2",
     "the value, times 1 + softening ln(1 + B/L)", 4096},
    {"rolling_nip.creep", "(R/L) (v(L1) - v(-L2))/L, mean strain of the surface in the contact",
     "(1 + L/B)/10 or the value, times 1 + softening ln(1 + B/L)", 4096},
}};

/// What is audited, and what of it unless ranges are given, for time.
constexpr double shortest_rolling = 1e-6, longest_rolling = 1000, shortest_memory = 1e-3,
                 longest_memory = 1e8;
constexpr double longest_drawn = 10, shortest_drawn_memory = 0.05;
/// So that fast keeps its promise: what softens much within a small part of the contact hardly carries anything.
double most_softening(double memory) { return 1 + std::min(100.0, 30 * memory); }

constexpr int least_rolling_digits = 16;

/// theta = at once [delta + (softening - 1)/tau e^(-t/tau)], theta2 with the rate of the solid; speed 1.
data::ViscoelasticNip rolling_nip(NipArguments x) {
  const double length = x[0], poisson = x[2], softening = x[3];
  check_nip_length(length);
  if (!(x[1] >= 1e-8 && x[1] <= 1e8)) throw data::BadInput("memory_over_L", x[1], "must be from 1e-8 to 1e8");
  if (!(poisson > -1 && poisson < 0.5))
    throw data::BadInput("poisson", poisson, "must satisfy -1 < poisson < 0.5 where the sheet has a memory");
  if (!(softening > 1 && softening <= 1e6))
    throw data::BadInput("softening", softening, "must be > 1 and at most 1e6");
  const double time = x[1] * length, theta1 = 1 + poisson, theta2 = theta1 * (1 - 2 * poisson);
  const auto function = [&](double at_once, double rate_factor) {
    return data::MaterialFunction{at_once, {{at_once * (softening - 1) / time, rate_factor / time}}};
  };
  return {nip_roller_radius, 1, {function(theta1, 1), function(theta2, x[4] == 0 ? 1 : 2)}, 1};
}

/// N at once as the material has it.
mpq_class exact_compliance(const data::ViscoelasticNip& nip) {
  const data::MaterialFunctions& functions = *nip.material.functions();
  return mpq_class(functions.theta1.instantaneous) + mpq_class(functions.theta2.instantaneous);
}

NipEstimates rolling_by_fast(NipArguments x, fast::Accuracy accuracy) {
  const data::ViscoelasticNip nip = rolling_nip(x);
  const auto contact = fast::converged_for_length(nip, x[0], nip_accuracy(accuracy));
  const double over_length = nip_roller_radius / x[0];
  const double compliance = nip.material.functions()->normal_compliance().instantaneous;
  return {in_unit(contact.rolling_resistance(), over_length), in_unit(contact.leading_length(), 1 / x[0]),
          in_unit(contact.load(), compliance * over_length / x[0]),
          in_unit(contact.indentation(), over_length / x[0]), in_unit(contact.creep_ratio(), over_length)};
}

/// Digits that the reference gives in about ten seconds, as measured: its unknowns grow with the logarithms of the length
/// and of how soon the sheet softens, their square is work, and each digit beyond 16 takes 16 % more.
int most_rolling_digits(NipArguments x) {
  const double steepness = std::max(1.0, (x[3] - 1) / 4) / x[1];
  const double unknowns = std::max({54.0, 10 + 150 * std::log10(steepness), 145 + 110 * std::log10(x[0])});
  const double seconds =
      (0.5 + unknowns / 500 + unknowns * unknowns / 47000) * (1 + 0.4 * std::min(1.0, x[0] / 5));
  return least_rolling_digits + static_cast<int>(std::floor(std::log(9 / seconds) / 0.15));
}

void check_rolling_work(NipArguments x, int digits) {
  if (x[0] < shortest_rolling)
    throw data::BadInput("L_over_B", x[0], "must be at least 1e-6 for rolling on the reference path");
  const int most = most_rolling_digits(x);
  if (digits <= most) return;
  const std::string here =
      fmt::format("L_over_B = {:.6g}, memory_over_L = {:.6g} and softening = {:.6g}", x[0], x[1], x[3]);
  if (most >= least_rolling_digits)
    throw data::BadInput("digits", std::to_string(digits),
                         fmt::format("must be at most {} for {}: more take too long", most, here));
  throw data::BadInput(
      "L_over_B", x[0],
      "must be smaller, or memory_over_L larger, or softening smaller, on the reference path: " + here +
          " take it too long");
}

NipReferences rolling_by_ref(NipArguments x, int digits) {
  const data::ViscoelasticNip nip = rolling_nip(x);
  check_rolling_work(x, digits);
  const auto contact = ref::converged_for_length(nip, x[0], digits);
  const mpq_class length = x[0], over_length = nip_roller_radius / length;
  return {in_unit(contact.rolling_resistance(), over_length), in_unit(contact.leading_length(), 1 / length),
          in_unit(contact.load(), exact_compliance(nip) * over_length / length),
          in_unit(contact.indentation(), over_length / length), in_unit(contact.creep_ratio(), over_length)};
}

double least_size(std::size_t number, NipArguments x) {
  if (number == 0) return 0.1;
  return number == 4 ? (1 + x[0]) / 10 : 0;
}

/// The misprinted solid is one for the thesis's constants; for others it may gain energy.
void keep_rolling_in_domain(Point& x) {
  x[0] = std::clamp(x[0], shortest_rolling, longest_rolling);
  x[1] = std::clamp(x[1], shortest_memory, longest_memory);
  x[2] = x[4] == 0 ? std::clamp(x[2], -0.9, 0.5 - 1e-9) : 1.0 / 3;
  x[3] = x[4] == 0 ? std::clamp(x[3], 1.001, most_softening(x[1])) : 2;
}

Point draw_rolling_nip_point(Random& random) {
  const double memory = random.chance(0.5) ? random.log_uniform(shortest_drawn_memory, 10)
                                           : random.log_uniform(10, longest_memory);
  const double softening = random.chance(0.3) ? 2 : 1 + random.log_uniform(1e-3, most_softening(memory) - 1);
  return {draw_nip_length(random, shortest_rolling, longest_drawn), memory, draw_nip_poisson(random),
          softening, random.chance(0.2) ? 1.0 : 0.0};
}

}  // namespace

std::vector<Quantity> viscoelastic_nip_entries() {
  std::vector<Quantity> entries;
  for (std::size_t i = 0; i < rolling_numbers.size(); ++i) {
    Quantity entry = nip_entry(rolling_numbers[i], "thesis 2.1-2.6, 7.6, 7.15, 7.17, continuous form",
                               "rolling_nip", {rolling_by_fast, rolling_by_ref}, i);
    entry.arguments = {{"L_over_B", ArgumentKind::positive, {}, {}},
                       {"memory_over_L", ArgumentKind::positive, {}, {}},
                       {"poisson", ArgumentKind::poisson, "0.3333333333333333", {}},
                       {"softening", ArgumentKind::positive, "2", {}},
                       {"material",
                        ArgumentKind::choice,
                        "standard-linear-solid",
                        {},
                        {"standard-linear-solid", "thesis-misprint"}}};
    entry.audit_points = 3;
    entry.most_digits = 30;
    entry.draw = draw_rolling_nip_point;
    entry.keep_off = keep_rolling_in_domain;
    entry.envelope = [i, value = entry.by_fast](NipArguments x) {
      return amplification(x) * std::max(least_size(i, x), std::fabs(value(x, {})));
    };
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace nipref::verify
