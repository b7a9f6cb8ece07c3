#include <algorithm>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/ref/material/internal/inverse_transform.hpp>
#include <nipref/ref/material/internal/material_compliances.hpp>
#include <nipref/ref/material/internal/partial_fractions.hpp>
#include <nipref/ref/memory/exact_material.hpp>

namespace nipref::ref {
namespace {

mpq_class exactly(const Float& x) { return to_exact(x).value(); }

ExactFunction exact_function(const Compliance& compliance, const char* name) {
  ExactFunction result{exactly(compliance.at_once), {}, {}};
  for (const ComplianceTerm& term : compliance.terms) {
    if (term.rate.im != 0)
      throw data::BadInput(std::string(name) + " rate", static_cast<double>(term.rate.im),
                           "must be real on the reference path");
    result.terms.push_back({exactly(term.amplitude.re), exactly(term.rate.re)});
  }
  return result;
}

mpq_class at_zero(const Polynomial& p) { return p.empty() ? mpq_class(0) : p.front(); }

ExactFunction exact_function(ExactRatio theta, const std::string& last) {
  auto& [numerator, denominator] = theta;
  cancel(numerator, denominator);
  const Polynomial at_once = divide(numerator, denominator);
  if (at_once.size() > 1)
    throw data::BadInput(last, "of the lower degree",
                         "must not let the solid give way without bound at once");
  if (has_repeated_root(denominator))
    throw data::BadInput(last, "(its roots)",
                         "must not be repeated: t e^(-rate t) is not among the terms of a material");
  ExactFunction result{at_zero(at_once), {}, {}};
  if (denominator.front() == 0) {  // a fluid, with the rate 0
    denominator.erase(denominator.begin());
    const mpq_class flow = at_zero(numerator) / denominator.front();
    result.terms.push_back({flow, 0});
    numerator = sum(numerator, product({mpq_class(-flow)}, denominator));
    numerator.erase(numerator.begin());
    numerator = trimmed(std::move(numerator));
  }
  if (numerator.empty()) return result;
  if (!(slowest_rate(denominator) > 0))
    throw data::BadInput(last, "(its roots)", "must have negative real parts: strains fade");
  if (denominator.size() == 2) {
    result.terms.push_back({numerator[0] / denominator[1], denominator[0] / denominator[1]});
    return result;
  }
  result.fractions.push_back(std::move(theta));
  return result;
}

}  // namespace

ExactFunction ExactMaterial::normal() const {
  ExactFunction sum{theta1.instantaneous + theta2.instantaneous, theta1.terms, theta1.fractions};
  sum.fractions.insert(sum.fractions.end(), theta2.fractions.begin(), theta2.fractions.end());
  for (const ExactFunction::Term& term : theta2.terms) {
    const auto same =
        std::ranges::find_if(sum.terms, [&](const ExactFunction::Term& x) { return x.rate == term.rate; });
    if (same == sum.terms.end()) {
      sum.terms.push_back(term);
    } else {
      same->amplitude += term.amplitude;
    }
  }
  return sum;
}

ExactMaterial exact_material(const data::ViscoelasticMaterial& material, int digits) {
  const WorkingDigits working(digits);
  const auto [theta1, theta2] = material_compliances(material);
  return {exact_function(theta1, "theta1"), exact_function(theta2, "theta2")};
}

ExactMaterial exact_material(const ExactRationalSolid& solid) {
  return {exact_function(solid.theta1, "Q"), exact_function(solid.theta2, "Q_dilatation")};
}

ExactMaterial exact_solid(Solid solid, const Exact& bulk, const Exact& tau) {
  const Exact shear(mpq_class(data::thesis_shear_over_bulk * bulk.value()));
  return exact_material(
      exact_single_time(bulk, shear, tau, solid == Solid::thesis ? data::misprinted_rate_factor : 1));
}

}  // namespace nipref::ref
