#include <complex>
#include <variant>

#include <nipref/ref/material/internal/material_compliances.hpp>
#include <nipref/ref/material/internal/polynomial.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {
namespace {

Compliance as_given(const data::MaterialFunction& function) {
  Compliance result{function.instantaneous, {}};
  for (const auto& [amplitude, rate] : function.terms)
    result.terms.push_back({{amplitude.real(), amplitude.imag()}, {rate.real(), rate.imag()}});
  return result;
}

ComplexFloat middle(const ComplexInterval& z) { return {middle_of(z.re), middle_of(z.im)}; }

/// The compliance in double, for the check whether the material is physical.
data::MaterialFunction in_double(const Compliance& compliance) {
  data::MaterialFunction function{static_cast<double>(compliance.at_once), {}};
  const auto rounded = [](const ComplexFloat& z) {
    return std::complex<double>(static_cast<double>(z.re), static_cast<double>(z.im));
  };
  for (const auto& [amplitude, rate] : compliance.terms)
    function.terms.push_back({rounded(amplitude), rounded(rate)});
  return function;
}

}  // namespace

Compliance compliance_of(const ExactFunction& theta) {
  Compliance result{to_float(theta.instantaneous), {}};
  for (const auto& [amplitude, rate] : theta.terms)
    result.terms.push_back({to_float(amplitude), to_float(rate)});
  for (const ExactRatio& fraction : theta.fractions) {
    for (const auto& [amplitude, rate] :
         partial_fractions(fraction.numerator, fraction.denominator, 2 * working_bits())) {
      if (mpfi_has_zero(rate.im.get()) > 0) {
        result.terms.push_back({middle_of(amplitude.re), middle_of(rate.re)});
      } else if (sign_of(rate.im) > 0) {
        const ComplianceTerm term{middle(amplitude), middle(rate)};
        result.terms.insert(result.terms.end(), {term, {conj(term.amplitude), conj(term.rate)}});
      }
    }
  }
  return result;
}

MaterialCompliances material_compliances(const data::ViscoelasticMaterial& material) {
  const auto& functions = material.functions();
  if (std::holds_alternative<std::monostate>(material.constants()))
    return {as_given(functions->theta1), as_given(functions->theta2)};
  const ExactMaterial exact = exact_material(material);
  const MaterialCompliances both{compliance_of(exact.theta1), compliance_of(exact.theta2)};
  if (!functions) data::MaterialFunctions{in_double(both.theta1), in_double(both.theta2)}.check();
  return both;
}

}  // namespace nipref::ref
