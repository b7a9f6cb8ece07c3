#include <utility>
#include <variant>

#include <nipref/fast/material/functions.hpp>
#include <nipref/fast/material/internal/partial_fractions.hpp>

namespace nipref::fast {
namespace {

using internal::Octuple;
using internal::Operators;
using internal::Polynomial;

Operators exactly(const std::vector<double>& p, const std::vector<double>& q) {
  return {Polynomial(p.begin(), p.end()), Polynomial(q.begin(), q.end())};
}

Operators exactly(const Modulus& m) {
  using data::SpringModel;
  const Octuple spring = m.spring, viscosity = m.viscosity;
  if (m.model == SpringModel::elastic) return {{1}, {spring}};
  if (m.model == SpringModel::kelvin_voigt) return {{1}, {spring, viscosity}};
  const Octuple second = m.model == SpringModel::maxwell ? 0 : m.second_spring;
  return {{spring + second, viscosity}, {spring * second, spring * viscosity}};
}

data::MaterialFunctions factored(const Operators& shear, const Operators& bulk, double shared) {
  const auto [theta1, theta2] = compliances_of(shear, bulk);
  return {partial_fractions(theta1, "Q", shared), partial_fractions(theta2, "Q_dilatation", shared)};
}

data::MaterialFunctions factored(const data::DifferentialOperators& x) {
  return factored(exactly(x.p, x.q), exactly(x.p_dilatation, x.q_dilatation), internal::of_rounded);
}

data::MaterialFunctions factored(const data::StandardLinearSolid& s) {
  constexpr auto model = data::SpringModel::standard_linear;
  return factored(exactly(Modulus{model, s.shear_1, s.shear_2, s.shear_viscosity}),
                  exactly(Modulus{model, s.bulk_1, s.bulk_2, s.bulk_viscosity}), internal::of_rounded);
}

}  // namespace

data::MaterialFunctions material_functions(const Modulus& shear, const Modulus& bulk) {
  return factored(exactly(shear), exactly(bulk), internal::of_exact);
}

data::MaterialFunctions material_functions(const data::ViscoelasticMaterial& material) {
  if (material.functions()) return *material.functions();
  const auto* operators = std::get_if<data::DifferentialOperators>(&material.constants());
  const data::MaterialFunctions functions =
      operators != nullptr ? factored(*operators)
                           : factored(std::get<data::StandardLinearSolid>(material.constants()));
  functions.check();
  return functions;
}

}  // namespace nipref::fast
