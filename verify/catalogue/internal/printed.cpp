#include <nipref/verify/catalogue/internal/printed.hpp>

namespace nipref::verify {
namespace {

/// The text of printed.txt, put here by the build.
const Formulas& printed_formulas() {
  static const Formulas all({},
#include <nipref_printed.inc>
  );
  return all;
}

}  // namespace

double printed(const std::string& function, const std::vector<double>& numbers, const GivenNumbers& given) {
  Formulas scope(given);
  return printed_formulas().value_of(function, {numbers.begin(), numbers.end()}, scope).value();
}

double printed_value(const std::string& formula, const GivenNumbers& given) {
  Formulas scope(given);
  return printed_formulas().compiled(formula)(scope).value();
}

GivenNumbers scaled_moduli(const data::TransverselyIsotropicSolid& half_space,
                           const data::IsotropicSolid& sphere) {
  const double mu = sphere.shear, poisson = sphere.poisson;
  return {{"c11", half_space.c11 / mu},
          {"c33", half_space.c33 / mu},
          {"c13", half_space.c13 / mu},
          {"c44", half_space.c44 / mu},
          {"c66", half_space.c66 / mu},
          {"scale", std::sqrt(half_space.density / sphere.density)},
          {"c_D", std::sqrt((2 - 2 * poisson) / (1 - 2 * poisson))}};
}

}  // namespace nipref::verify
