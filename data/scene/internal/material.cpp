#include <functional>

#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/data/scene/internal/read.hpp>

namespace nipref::data {
namespace {

/// Makes the material of the numbers that were read. The caller adds the place in the file to what the model refuses.
using Build = std::function<ViscoelasticMaterial()>;

Build read_elastic(const SceneTable& material) {
  material.allow("elastic-solid");
  const ElasticMaterial elastic{material.number("young"), material.number("poisson")};
  return [=] { return elastic_solid(elastic); };
}

/// The solid is given by its one relaxation time or by all six constants.
Build read_standard_linear(const SceneTable& material) {
  if (material.has("relaxation_time")) {
    material.allow("one-relaxation-time");
    const double bulk = material.number("bulk"), shear = material.number("shear");
    const double relaxation_time = material.number("relaxation_time");
    return [=] { return single_relaxation_time_solid(bulk, shear, relaxation_time); };
  }
  material.allow("six-constants");
  const StandardLinearSolid solid{material.number("shear_1"),         material.number("shear_2"),
                                  material.number("bulk_1"),          material.number("bulk_2"),
                                  material.number("shear_viscosity"), material.number("bulk_viscosity")};
  return [=] { return standard_linear_solid(solid); };
}

Build read_thesis_misprint(const SceneTable& material) {
  material.allow("one-relaxation-time");
  const double bulk = material.number("bulk");
  const double shear = material.has("shear") ? material.number("shear") : thesis_shear_over_bulk * bulk;
  const double relaxation_time = material.number("relaxation_time");
  return [=] { return single_relaxation_time_solid(bulk, shear, relaxation_time, misprinted_rate_factor); };
}

PronyList read_prony_list(const SceneTable& material, const std::string& name) {
  return {material.number(name + "_instantaneous"), material.numbers(name + "_amplitudes"),
          material.numbers(name + "_rates")};
}

Build read_prony(const SceneTable& material) {
  material.allow("prony");
  return [theta1 = read_prony_list(material, "theta1"), theta2 = read_prony_list(material, "theta2")] {
    return prony_solid(theta1, theta2);
  };
}

Build read_operators(const SceneTable& material) {
  material.allow("operators");
  const DifferentialOperators operators{material.numbers("P"), material.numbers("Q"),
                                        material.numbers("P_dilatation"), material.numbers("Q_dilatation")};
  return [=] { return operator_solid(operators); };
}

Build read_model(const SceneTable& material) {
  const std::string model = material_model(material);
  if (model == "elastic") return read_elastic(material);
  if (model == "standard-linear-solid") return read_standard_linear(material);
  if (model == "thesis-misprint") return read_thesis_misprint(material);
  if (model == "prony") return read_prony(material);
  return read_operators(material);
}

}  // namespace

std::string material_model(const SceneTable& material) { return material.choice("model"); }

ViscoelasticMaterial read_viscoelastic_material(const SceneTable& material, const SceneOrigin& origin) {
  const Build build = read_model(material);
  try {
    return build();
  } catch (const NoMaterial& error) {
    origin.refuse_as(error.key(), error);
  } catch (const BadInput& error) {
    origin.refuse_as("material." + error.argument(), error);
  }
}

}  // namespace nipref::data
