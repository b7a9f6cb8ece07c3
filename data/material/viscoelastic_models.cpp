#include <cmath>
#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/magnitude.hpp>
#include <nipref/data/material/viscoelastic_models.hpp>

namespace nipref::data {
namespace {

Compliances compliances(double bulk, double shear) {
  check_magnitude("bulk", bulk);
  check_magnitude("shear", shear);
  return {1 / (2 * shear), 3 / (6 * bulk + 2 * shear)};
}

/// theta = at_once (delta(t) + e^(-rate t)/relaxation_time), the rate of theta2 being so many times
/// 1/relaxation_time.
ViscoelasticMaterial relaxing(const Compliances& at_once, double relaxation_time, int theta2_rate_factor,
                              const MaterialConstants& constants = {}) {
  // It may be so short or so long that it no longer matters: it need not be a magnitude.
  if (!(std::isfinite(relaxation_time) && relaxation_time > 0))
    throw NoMaterial("relaxation_time", relaxation_time, "must be finite and > 0");
  const auto function = [&](double compliance, int rate_factor) -> MaterialFunction {
    const double amplitude = compliance / relaxation_time, rate = rate_factor / relaxation_time;
    if (!(std::isfinite(amplitude) && std::isfinite(rate)))
      throw NoMaterial("relaxation_time", relaxation_time,
                       "must be so long that what is divided by it stays within the range of doubles");
    return {compliance, {{amplitude, rate}}};
  };
  return {function(at_once.theta1, 1), function(at_once.theta2, theta2_rate_factor), constants};
}

MaterialFunction prony_function(const PronyList& list, const std::string& name) {
  if (list.amplitudes.empty())
    throw NoMaterial(name + "_amplitudes", "[]",
                     "must hold at least one: without it the material is elastic");
  if (list.rates.size() != list.amplitudes.size()) {
    throw NoMaterial(name + "_rates", std::to_string(list.rates.size()) + " of them",
                     "must be as many as amplitudes, " + std::to_string(list.amplitudes.size()));
  }
  MaterialFunction function{list.instantaneous, {}};
  for (std::size_t i = 0; i < list.rates.size(); ++i)
    function.terms.push_back({list.amplitudes[i], list.rates[i]});
  return function;
}

}  // namespace

ViscoelasticMaterial elastic_solid(const ElasticMaterial& material) {
  material.check();
  // An incompressible one has theta2 = 0, which no viscoelastic material has.
  return {{material.theta1(), {}}, {material.theta2(), {}}, material};
}

ViscoelasticMaterial standard_linear_solid(const StandardLinearSolid& solid) {
  return ViscoelasticMaterial(solid);
}

ViscoelasticMaterial single_relaxation_time_solid(double bulk, double shear, double relaxation_time) {
  return relaxing(compliances(bulk, shear), relaxation_time, 1,
                  SingleRelaxationTimeSolid{bulk, shear, relaxation_time, 1});
}

ViscoelasticMaterial misprinted_thesis_solid(double bulk, double shear, double relaxation_time) {
  return relaxing(compliances(bulk, shear), relaxation_time, misprinted_rate_factor,
                  SingleRelaxationTimeSolid{bulk, shear, relaxation_time, misprinted_rate_factor});
}

ViscoelasticMaterial single_relaxation_time_solid(const Compliances& at_once, double relaxation_time) {
  return relaxing(at_once, relaxation_time, 1);
}

ViscoelasticMaterial misprinted_thesis_solid(const Compliances& at_once, double relaxation_time) {
  return relaxing(at_once, relaxation_time, misprinted_rate_factor);
}

ViscoelasticMaterial prony_solid(const PronyList& theta1, const PronyList& theta2) {
  return {prony_function(theta1, "theta1"), prony_function(theta2, "theta2")};
}

ViscoelasticMaterial operator_solid(const DifferentialOperators& operators) {
  return ViscoelasticMaterial(operators);
}

}  // namespace nipref::data
