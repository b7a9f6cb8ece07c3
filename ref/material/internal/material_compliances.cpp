#include <complex>
#include <variant>

#include <nipref/ref/material/internal/material_compliances.hpp>
#include <nipref/ref/material/internal/partial_fractions.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {
namespace {

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

ComplexFloat middle(const ComplexInterval& z) { return {middle_of(z.re), middle_of(z.im)}; }

/// The compliance in double, for the check whether the material is physical.
data::MaterialFunction in_double(const Compliance& compliance) {
  data::MaterialFunction function{static_cast<double>(compliance.at_once), {}};
  const auto rounded = [](const ComplexFloat& z) {
    return std::complex<double>(static_cast<double>(z.re), static_cast<double>(z.im));
  };
  for (const ComplianceTerm& term : compliance.terms) {
    const std::complex<double> amplitude = rounded(term.amplitude), rate = rounded(term.rate);
    if (rate.imag() == 0) {
      function.terms.push_back({amplitude.real(), rate});
    } else {
      function.terms.push_back({amplitude / 2.0, rate});
      function.terms.push_back({std::conj(amplitude) / 2.0, std::conj(rate)});
    }
  }
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
      } else if (sign_of(rate.im) > 0) {  // that of the conjugate rate stands with it
        result.terms.push_back({middle(amplitude) * Float(2), middle(rate)});
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
