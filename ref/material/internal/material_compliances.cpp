#include <complex>
#include <utility>
#include <variant>

#include <nipref/ref/material/internal/material_compliances.hpp>

namespace nipref::ref {
namespace {

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

/// The compliance in double, for the check whether the material is physical.
data::MaterialFunction rounded(const Compliance& compliance) {
  data::MaterialFunction function{static_cast<double>(compliance.at_once), {}};
  for (const ComplianceTerm& term : compliance.terms) {
    const auto in_double = [](const ComplexFloat& z) {
      return std::complex<double>(static_cast<double>(z.re), static_cast<double>(z.im));
    };
    const std::complex<double> amplitude = in_double(term.amplitude), rate = in_double(term.rate);
    if (rate.imag() == 0) {
      function.terms.push_back({amplitude.real(), rate});
    } else {
      function.terms.push_back({amplitude / 2.0, rate});
      function.terms.push_back({std::conj(amplitude) / 2.0, std::conj(rate)});
    }
  }
  return function;
}

/// The compliances from the constants of each material model.
struct FromConstants {
  const data::ViscoelasticMaterial& material;

  MaterialCompliances operator()(std::monostate) const {
    return {as_given(material.functions()->theta1), as_given(material.functions()->theta2)};
  }
  MaterialCompliances operator()(const data::ElasticMaterial& solid) const {
    const mpq_class young = solid.young, poisson = solid.poisson;
    return {{quotient((1 + poisson) / young), {}}, {quotient((1 + poisson) * (1 - 2 * poisson) / young), {}}};
  }
  MaterialCompliances operator()(const data::SingleRelaxationTimeSolid& solid) const {
    const mpq_class bulk = solid.bulk, shear = solid.shear, time = solid.relaxation_time;
    const auto relaxing = [&](const mpq_class& at_once, int rate_factor) -> Compliance {
      return {quotient(at_once), {{{quotient(at_once / time)}, {quotient(rate_factor / time)}}}};
    };
    return {relaxing(1 / (2 * shear), 1), relaxing(3 / (6 * bulk + 2 * shear), solid.theta2_rate_factor)};
  }
  MaterialCompliances operator()(const data::StandardLinearSolid& s) const {
    const auto operators = [](const mpq_class& first, const mpq_class& second, const mpq_class& viscosity) {
      return std::pair(Polynomial{first + second, viscosity}, Polynomial{first * second, first * viscosity});
    };
    const auto [p, q] = operators(s.shear_1, s.shear_2, s.shear_viscosity);
    const auto [p_dilatation, q_dilatation] = operators(s.bulk_1, s.bulk_2, s.bulk_viscosity);
    return from_operators(p, q, p_dilatation, q_dilatation);
  }
  MaterialCompliances operator()(const data::DifferentialOperators& operators) const {
    const auto exact = [](const std::vector<double>& coefficients) {
      return Polynomial(coefficients.begin(), coefficients.end());
    };
    return from_operators(exact(operators.p), exact(operators.q), exact(operators.p_dilatation),
                          exact(operators.q_dilatation));
  }

 private:
  /// theta1 = P/(2Q), theta2 = 3 P P'/(6 Q' P + 2 Q P')
  static MaterialCompliances from_operators(const Polynomial& p, const Polynomial& q,
                                            const Polynomial& p_dilatation, const Polynomial& q_dilatation) {
    const MaterialCompliances both{rational_compliance(p, product({2}, q), "Q"),
                                   rational_compliance(product(product({3}, p), p_dilatation),
                                                       sum(product(product({6}, q_dilatation), p),
                                                           product(product({2}, q), p_dilatation)),
                                                       "Q_dilatation")};
    data::MaterialFunctions{rounded(both.theta1), rounded(both.theta2)}.check();
    return both;
  }
};

}  // namespace

MaterialCompliances material_compliances(const data::ViscoelasticMaterial& material) {
  return std::visit(FromConstants{material}, material.constants());
}

}  // namespace nipref::ref
