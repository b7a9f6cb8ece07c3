#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/material/internal/polynomial.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_sheet.hpp>

namespace nipref::ref {
namespace {

using Terms = std::vector<RollingMemory>;

/// The terms of equal rate, to rounding, are joined.
void add_term(Terms& terms, const RollingMemory& term) {
  const auto same = std::ranges::find_if(terms, [&](const RollingMemory& other) {
    return abs(other.rate - term.rate) <= ldexp(abs(other.rate), 16 - working_bits());
  });
  if (same == terms.end())
    terms.push_back(term);
  else
    same->amplitude = same->amplitude + term.amplitude;
}

/// Widths at an end over those without memory, times the largest rate.
constexpr double widest_of_memory = 1.5;

Terms with_conjugates(const Terms& terms) {
  Terms all;
  for (const RollingMemory& term : terms) {
    if (abs(term.amplitude) == 0) continue;
    if (term.rate.is_real()) {
      all.push_back({ComplexFloat(term.amplitude.re), term.rate});
      continue;
    }
    const ComplexFloat half = term.amplitude / Float(2);
    all.push_back({half, term.rate});
    all.push_back({ComplexFloat(half.re, -half.im), ComplexFloat(term.rate.re, -term.rate.im)});
  }
  return all;
}

/// The zeros of C(-s), as those of C(-s) prod (r_i - s). They start beside the real axis, as real steps find no complex zeros.
std::vector<ComplexFloat> zeros_of(const Terms& terms) {
  const ComplexFloat beside(1, Float(1) / 8);
  std::vector<ComplexFloat> guesses;
  for (const RollingMemory& term : terms) guesses.push_back(term.rate + term.amplitude * beside);
  const auto slope_over_value = [&](const ComplexFloat& s) -> std::optional<ComplexFloat> {
    ComplexFloat value(1), slope, poles;
    for (const RollingMemory& term : terms) {
      const ComplexFloat distance = term.rate - s, part = term.amplitude / distance;
      value = value + part;
      slope = slope + part / distance;
      poles = poles + ComplexFloat(1) / distance;
    }
    if (abs(value) == 0) return std::nullopt;
    return slope / value - poles;
  };
  return zeros_by_steps(std::move(guesses), slope_over_value, ldexp(Float(1), 8 - working_bits()));
}

}  // namespace

RollingMaterial rolling_material(const data::ViscoelasticNip& nip) {
  const auto [theta1, theta2] = material_compliances(nip.material);
  RollingMaterial result{theta1.at_once + theta2.at_once, {}, 0, {}};
  result.theta2_at_once = theta2.at_once / result.compliance;
  const Float ways = Float(nip.sheet_thickness) / 2 / nip.speed;  // half-thicknesses in a unit of time
  const auto add_rolled = [&](Terms& terms, const Terms& in_time) {
    for (const auto& [amplitude, rate] : in_time)
      add_term(terms, {amplitude * (ways / result.compliance), rate * ways});
  };
  add_rolled(result.theta2, theta2.terms);
  add_rolled(result.normal, theta1.terms);
  add_rolled(result.normal, theta2.terms);
  return result;
}

RollingSheet::RollingSheet(RollingMaterial the_material)
    : material(std::move(the_material)), memory(with_conjugates(material.normal)) {
  for (const ComplexFloat& s : zeros_of(memory)) {
    ComplexFloat sum;
    for (const RollingMemory& term : memory) {
      const ComplexFloat distance = term.rate - s;
      sum = sum - term.amplitude / (distance * distance);
    }
    inverse.push_back({ComplexFloat(1) / sum, s});
  }
}

Resolution RollingSheet::resolution() const {
  Resolution resolution{std::numbers::pi, {}, 1};
  for (const auto* terms : {&memory, &inverse}) {
    for (const RollingMemory& term : *terms) {
      resolution.rates.emplace_back(static_cast<double>(term.rate.re), static_cast<double>(term.rate.im));
      resolution.first = std::min(resolution.first, widest_of_memory / std::abs(resolution.rates.back()));
    }
  }
  return resolution;
}

int RollingSheet::unknowns(int terms) const {
  return 2 * (terms + 1) + 2 + 2 * static_cast<int>(inverse.size());
}

void RollingSheet::check(double half_length) const {
  constexpr double shortest_memory = 1e-8, longest_memory = 1e8;
  for (const RollingMemory& term : material.normal) {
    const double length = 2 * half_length;
    if (is_flow(term)) continue;
    const double shortest = 1 / static_cast<double>(abs(term.rate)),
                 longest = 1 / static_cast<double>(term.rate.re);
    if (shortest < shortest_memory * length || longest > longest_memory * length)
      throw data::BadInput("nip.material", shortest / length,
                           "must have relaxation lengths from 1e-8 to 1e8 contacts for the reference");
  }
}

int RollingSheet::lost_digits() const {
  double softness = 1;
  for (const RollingMemory& term : memory)
    softness +=
        static_cast<double>(is_flow(term) ? abs(term.amplitude) : abs(term.amplitude) / abs(term.rate));
  return static_cast<int>(std::log10(softness));
}

}  // namespace nipref::ref
