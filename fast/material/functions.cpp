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

ExactOperators operators_of(const data::StandardLinearSolid& s) {
  const auto ratio = [](const Octuple& first, const Octuple& second, const Octuple& viscosity) {
    return std::pair(Polynomial{first + second, viscosity}, Polynomial{first * second, first * viscosity});
  };
  const auto [p, q] = ratio(s.shear_1, s.shear_2, s.shear_viscosity);
  const auto [p_dilatation, q_dilatation] = ratio(s.bulk_1, s.bulk_2, s.bulk_viscosity);
  return {p, q, p_dilatation, q_dilatation};
}

/// theta1 = P/(2Q), theta2 = 3 P P'/(6 Q' P + 2 Q P')
data::MaterialFunctions factored(const ExactOperators& operators) {
  const auto& [p, q, p_dilatation, q_dilatation] = operators;
  const Polynomial six = product({6}, q_dilatation), two = product({2}, q);
  const data::MaterialFunction theta1 = partial_fractions({p}, two, "Q");
  // A factor P that both have is left out at once: rounding would split its double root.
  if (p == p_dilatation) return {theta1, partial_fractions({{3}, p}, sum(six, two), "Q_dilatation")};
  const Polynomial denominator = sum(product(six, p), product(two, p_dilatation));
  return {theta1, partial_fractions({{3}, p, p_dilatation}, denominator, "Q_dilatation")};
}

}  // namespace

data::MaterialFunctions material_functions(const data::ViscoelasticMaterial& material) {
  if (material.functions()) return *material.functions();
  const auto* operators = std::get_if<data::DifferentialOperators>(&material.constants());
  const data::MaterialFunctions functions = factored(
      operators != nullptr ? operators_of(*operators)
                           : operators_of(std::get<data::StandardLinearSolid>(material.constants())));
  functions.check();
  return functions;
}

}  // namespace nipref::fast
