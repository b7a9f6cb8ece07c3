#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rational_compliance.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_material.hpp>

namespace nipref::ref {
namespace {

using Terms = std::vector<RollingMemory>;

struct BothCompliances {
  Compliance theta1, theta2;
};

Float quotient(const mpq_class& value) { return to_float(Exact(value)); }

Compliance as_given(const data::MaterialFunction& function) {
  Compliance result{function.instantaneous, {}};
  for (const data::RelaxationTerm& term : function.terms) {
    if (term.rate.imag() < 0) continue;
    const int both = term.rate.imag() > 0 ? 2 : 1;
    result.terms.push_back({ComplexFloat(term.amplitude.real(), term.amplitude.imag()) * Float(both),
                            {term.rate.real(), term.rate.imag()}});
  }
  return result;
}

/// From what a material was made of.
struct FromConstants {
  const data::ViscoelasticMaterial& material;

  BothCompliances operator()(std::monostate) const {
    return {as_given(material.theta1()), as_given(material.theta2())};
  }
  BothCompliances operator()(const data::ElasticMaterial& solid) const {
    const mpq_class young = solid.young, poisson = solid.poisson;
    return {{quotient((1 + poisson) / young), {}}, {quotient((1 + poisson) * (1 - 2 * poisson) / young), {}}};
  }
  BothCompliances operator()(const data::SingleRelaxationTimeSolid& solid) const {
    const mpq_class bulk = solid.bulk, shear = solid.shear, time = solid.relaxation_time;
    const auto relaxing = [&](const mpq_class& at_once, int rate_factor) -> Compliance {
      return {quotient(at_once), {{{quotient(at_once / time)}, {quotient(rate_factor / time)}}}};
    };
    return {relaxing(1 / (2 * shear), 1), relaxing(3 / (6 * bulk + 2 * shear), solid.theta2_rate_factor)};
  }
  BothCompliances operator()(const data::StandardLinearSolid& s) const {
    const auto operators = [](const mpq_class& first, const mpq_class& second, const mpq_class& viscosity) {
      return std::pair(Polynomial{first + second, viscosity}, Polynomial{first * second, first * viscosity});
    };
    const auto [p, q] = operators(s.shear_1, s.shear_2, s.shear_viscosity);
    const auto [p_dilatation, q_dilatation] = operators(s.bulk_1, s.bulk_2, s.bulk_viscosity);
    return from_operators(p, q, p_dilatation, q_dilatation);
  }
  BothCompliances operator()(const data::DifferentialOperators& operators) const {
    const auto exact = [](const std::vector<double>& coefficients) {
      return Polynomial(coefficients.begin(), coefficients.end());
    };
    return from_operators(exact(operators.p), exact(operators.q), exact(operators.p_dilatation),
                          exact(operators.q_dilatation));
  }

  /// theta1 = P/(2Q), theta2 = 3 P P'/(6 Q' P + 2 Q P')
  static BothCompliances from_operators(const Polynomial& p, const Polynomial& q,
                                        const Polynomial& p_dilatation, const Polynomial& q_dilatation) {
    return {rational_compliance(p, product({2}, q)),
            rational_compliance(
                product(product({3}, p), p_dilatation),
                sum(product(product({6}, q_dilatation), p), product(product({2}, q), p_dilatation)))};
  }
};

/// Equal to rounding.
bool same_rate(const ComplexFloat& x, const ComplexFloat& y) {
  return abs(x - y) <= ldexp(abs(x), 16 - mpfr_get_prec(Float().get()));
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
  const auto [theta1, theta2] = std::visit(FromConstants{nip.material}, nip.material.constants());
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
