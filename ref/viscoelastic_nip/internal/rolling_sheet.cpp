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

/// Widths at an end over those without memory, times the largest rate.
constexpr double widest_of_memory = 1.5;

std::vector<RollingMemory> with_conjugates(const std::vector<RollingMemory>& terms) {
  std::vector<RollingMemory> all;
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
std::vector<ComplexFloat> zeros_of(const std::vector<RollingMemory>& terms) {
  constexpr int most_rounds = 400;
  const ComplexFloat beside(1, Float(1) / 8);
  std::vector<ComplexFloat> zeros;
  for (const RollingMemory& term : terms) zeros.push_back(term.rate + term.amplitude * beside);
  const Float enough = ldexp(Float(1), 8 - working_bits());
  for (int round = 0; round < most_rounds; ++round) {
    Float largest = 0;
    for (std::size_t j = 0; j < zeros.size(); ++j) {
      const ComplexFloat s = zeros[j];
      ComplexFloat value(1), slope, poles;
      for (const RollingMemory& term : terms) {
        const ComplexFloat distance = term.rate - s, part = term.amplitude / distance;
        value = value + part;
        slope = slope + part / distance;
        poles = poles + ComplexFloat(1) / distance;
      }
      if (abs(value) == 0) continue;
      const ComplexFloat change = zero_correction(zeros, j, slope / value - poles);
      zeros[j] = s - change;
      largest = std::max(largest, Float(abs(change) / abs(s)));
    }
    if (largest < enough) break;
  }
  return zeros;
}

}  // namespace

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
