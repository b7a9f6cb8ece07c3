#include <utility>
#include <variant>

#include <nipref/fast/material/functions.hpp>
#include <nipref/fast/material/internal/partial_fractions.hpp>

namespace nipref::fast {
namespace {

using internal::Octuple;
using internal::partial_fractions;
using internal::Polynomial;
using internal::product;
using internal::sum;

struct ExactOperators {
  Polynomial p, q, p_dilatation, q_dilatation;
};

ExactOperators operators_of(const data::DifferentialOperators& x) {
  const auto exactly = [](const std::vector<double>& c) { return Polynomial(c.begin(), c.end()); };
  return {exactly(x.p), exactly(x.q), exactly(x.p_dilatation), exactly(x.q_dilatation)};
}

struct ExactModulus {
  Polynomial p, q;
};

ExactModulus exactly(const Modulus& m) {
  using data::SpringModel;
  const Octuple spring = m.spring, viscosity = m.viscosity;
  if (m.model == SpringModel::elastic) return {{1}, {spring}};
  if (m.model == SpringModel::kelvin_voigt) return {{1}, {spring, viscosity}};
  const Octuple second = m.model == SpringModel::maxwell ? 0 : m.second_spring;
  return {{spring + second, viscosity}, {spring * second, spring * viscosity}};
}

ExactOperators operators_of(const Modulus& shear, const Modulus& bulk) {
  const ExactModulus G = exactly(shear), K = exactly(bulk);
  return {G.p, G.q, K.p, K.q};
}

ExactOperators operators_of(const data::StandardLinearSolid& s) {
  constexpr auto model = data::SpringModel::standard_linear;
  return operators_of({model, s.shear_1, s.shear_2, s.shear_viscosity},
                      {model, s.bulk_1, s.bulk_2, s.bulk_viscosity});
}

/// theta1 = P/(2Q), theta2 = 3 P P'/(6 Q' P + 2 Q P')
data::MaterialFunctions factored(const ExactOperators& operators, double shared) {
  const auto& [p, q, p_dilatation, q_dilatation] = operators;
  const Polynomial six = product({6}, q_dilatation), two = product({2}, q);
  const data::MaterialFunction theta1 = partial_fractions({p}, two, "Q", shared);
  // A factor P that both have is left out at once: rounding would split its double root.
  if (p == p_dilatation) return {theta1, partial_fractions({{3}, p}, sum(six, two), "Q_dilatation", shared)};
  const Polynomial denominator = sum(product(six, p), product(two, p_dilatation));
  return {theta1, partial_fractions({{3}, p, p_dilatation}, denominator, "Q_dilatation", shared)};
}

}  // namespace

data::MaterialFunctions material_functions(const Modulus& shear, const Modulus& bulk) {
  return factored(operators_of(shear, bulk), internal::of_exact);
}

data::MaterialFunctions material_functions(const data::ViscoelasticMaterial& material) {
  if (material.functions()) return *material.functions();
  const auto* operators = std::get_if<data::DifferentialOperators>(&material.constants());
  const data::MaterialFunctions functions =
      factored(operators != nullptr ? operators_of(*operators)
                                    : operators_of(std::get<data::StandardLinearSolid>(material.constants())),
               internal::of_rounded);
  functions.check();
  return functions;
}

}  // namespace nipref::fast
