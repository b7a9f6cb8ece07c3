#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/ref/material/internal/material_compliances.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_material.hpp>

namespace nipref::ref {
namespace {

using Terms = std::vector<RollingMemory>;

/// Equal to rounding.
bool same_rate(const ComplexFloat& x, const ComplexFloat& y) {
  return abs(x - y) <= ldexp(abs(x), 16 - working_bits());
}

void add_term(Terms& terms, const RollingMemory& term) {
  const auto same = std::ranges::find_if(
      terms, [&](const RollingMemory& other) { return same_rate(other.rate, term.rate); });
  if (same == terms.end()) {
    terms.push_back(term);
  } else {
    same->amplitude = same->amplitude + term.amplitude;
  }
}

}  // namespace

RollingMaterial rolling_material(const data::ViscoelasticNip& nip) {
  const auto [theta1, theta2] = material_compliances(nip.material);
  RollingMaterial result{theta1.at_once + theta2.at_once, {}, 0, {}};
  result.theta2_at_once = theta2.at_once / result.compliance;
  const Float ways = Float(nip.sheet_thickness) / 2 / nip.speed;  // half-thicknesses in a unit of time
  const auto rolled = [&](const ComplianceTerm& term) -> RollingMemory {
    return {term.amplitude * (ways / result.compliance), term.rate * ways};
  };
  for (const ComplianceTerm& term : theta2.terms) add_term(result.theta2, rolled(term));
  for (const ComplianceTerm& term : theta1.terms) add_term(result.normal, rolled(term));
  for (const RollingMemory& term : result.theta2) add_term(result.normal, term);
  return result;
}

}  // namespace nipref::ref
