#include <algorithm>
#include <utility>

#include <nipref/data/scene/keys.hpp>

namespace nipref::data {
namespace {

constexpr Dimension of_length{1, 0, 0}, of_stress{0, 1, 0}, of_time{0, 0, 1}, of_rate{0, 0, -1};
constexpr Dimension of_speed{1, 0, -1}, of_density{-2, 1, 2}, of_viscosity{0, 1, 1};
constexpr Dimension of_compliance{0, -1, 0}, of_compliance_rate{0, -1, -1};
constexpr auto nip_scene = SceneKind::nip, half_space_scene = SceneKind::half_space;
using enum KeyOwner;

}  // namespace

std::string Dimension::text() const {
  std::string text;
  for (const auto& [name, exponent] : {std::pair("length", length), {"stress", stress}, {"time", time}}) {
    if (exponent == 0) continue;
    text += (text.empty() ? "" : " ") + std::string(name);
    if (exponent != 1) text += "^" + std::to_string(exponent);
  }
  return text.empty() ? "1" : text;
}

std::string_view SceneKey::table() const {
  const std::size_t dot = name.find('.');
  return dot == std::string_view::npos ? std::string_view{} : name.substr(0, dot);
}

std::string_view SceneKey::last() const { return name.substr(name.find('.') + 1); }

const std::vector<SceneKey>& scene_keys() {
  static const std::vector<SceneKey> keys{
      {"title", "a line that names the scene"},
      {"wanted", "names of the results"},
      {"accuracy", "relative error that is asked for"},
      {"roller.radius", "radius of each of the two equal rollers", of_length, nip_scene},
      {"sheet.thickness", "full thickness of the sheet", of_length, nip_scene},
      {"material.model", "the material of the sheet", {}, nip_scene},
      {"material.young", "Young's modulus", of_stress, nip_scene, {elastic_solid}},
      {"material.poisson", "Poisson's ratio", {}, nip_scene, {elastic_solid}},
      {"material.bulk", "bulk modulus", of_stress, nip_scene, {one_relaxation_time}},
      {"material.shear",
       "shear modulus of the standard linear solid",
       of_stress,
       nip_scene,
       {one_relaxation_time}},
      {"material.relaxation_time",
       "relaxation time of the solid",
       of_time,
       nip_scene,
       {one_relaxation_time, six_constants}},
      {"material.shear_1", "first shear modulus of the six constants", of_stress, nip_scene, {six_constants}},
      {"material.shear_2", "second shear modulus", of_stress, nip_scene, {six_constants}},
      {"material.bulk_1", "first bulk modulus", of_stress, nip_scene, {six_constants}},
      {"material.bulk_2", "second bulk modulus", of_stress, nip_scene, {six_constants}},
      {"material.shear_viscosity", "viscosity in shear", of_viscosity, nip_scene, {six_constants}},
      {"material.bulk_viscosity", "viscosity in dilatation", of_viscosity, nip_scene, {six_constants}},
      {"material.theta1_instantaneous", "instantaneous part of theta1", of_compliance, nip_scene, {prony}},
      {"material.theta1_amplitudes",
       "amplitudes of its exponentials",
       of_compliance_rate,
       nip_scene,
       {prony}},
      {"material.theta1_rates", "their rates", of_rate, nip_scene, {prony}},
      {"material.theta2_instantaneous", "instantaneous part of theta2", of_compliance, nip_scene, {prony}},
      {"material.theta2_amplitudes",
       "amplitudes of its exponentials",
       of_compliance_rate,
       nip_scene,
       {prony}},
      {"material.theta2_rates", "their rates", of_rate, nip_scene, {prony}},
      {"material.P",
       "coefficients of the deviatoric stress operator, the derivative's order ascending",
       {},
       nip_scene,
       {operators},
       true},
      {"material.Q",
       "coefficients of the deviatoric strain operator",
       of_stress,
       nip_scene,
       {operators},
       true},
      {"material.P_dilatation",
       "coefficients of the dilatational stress operator",
       {},
       nip_scene,
       {operators},
       true},
      {"material.Q_dilatation",
       "coefficients of the dilatational strain operator",
       of_stress,
       nip_scene,
       {operators},
       true},
      {"half_space.model", "the material of the half-space", {}, half_space_scene},
      {"half_space.shear", "shear modulus", of_stress, half_space_scene, {isotropic}},
      {"half_space.poisson", "Poisson's ratio", {}, half_space_scene, {isotropic}},
      {"half_space.stiffness",
       "the 21 constants of the upper triangle, row after row",
       of_stress,
       half_space_scene,
       {anisotropic}},
      {"half_space.axis", "the solid's axis of symmetry", {}, half_space_scene, {transversely_isotropic}},
      {"half_space.c11", "stiffness across the axis", of_stress, half_space_scene, {transversely_isotropic}},
      {"half_space.c33", "stiffness along the axis", of_stress, half_space_scene, {transversely_isotropic}},
      {"half_space.c13", "stiffness between both", of_stress, half_space_scene, {transversely_isotropic}},
      {"half_space.c44",
       "shear modulus along the axis",
       of_stress,
       half_space_scene,
       {transversely_isotropic}},
      {"half_space.c66",
       "shear modulus across the axis",
       of_stress,
       half_space_scene,
       {transversely_isotropic}},
      {"half_space.density", "density", of_density, half_space_scene},
      {"die.radius_along", "the die's radius of curvature along its first axis", of_length, half_space_scene},
      {"die.radius_across", "the same across it", of_length, half_space_scene},
      {"rolling_sphere.radius", "radius of the rigid rolling sphere", of_length, half_space_scene},
      {"sphere.radius", "radius of the elastic sphere", of_length, half_space_scene},
      {"sphere.shear", "shear modulus of the sphere", of_stress, half_space_scene},
      {"sphere.poisson", "Poisson's ratio of the sphere", {}, half_space_scene},
      {"sphere.density", "density of the sphere", of_density, half_space_scene},
      {"sphere.patch", "whether the contact patch moves in the sphere's own material", {}, half_space_scene},
      {"sliding.speed", "speed of sliding", of_speed, half_space_scene},
      {"sliding.direction", "direction of sliding from x1, degrees", {}, half_space_scene},
      {"sliding.friction", "coefficient of friction", {}, half_space_scene},
      {"rolling.speed", "speed of rolling", of_speed},
      {"load.per_length", "load per unit width of the nip", {1, 1, 0}, nip_scene},
      {"load.normal_force", "force that presses the body down", {2, 1, 0}, half_space_scene},
      {"contact.length", "full length of the contact", of_length, nip_scene},
      {"contact.span_along", "extent of the contact along the motion", of_length, half_space_scene},
      {"friction.model", "friction between rollers and sheet", {}, nip_scene},
      {"friction.creep_ratio",
       "creep ratio of line loads with full friction, in place of the chosen one",
       {},
       nip_scene,
       {elastic_nip}},
      {"method.kind", "how the contact is computed"},
      {"method.leading_elements",
       "elements ahead of the point of first touch",
       {},
       nip_scene,
       {elastic_line_loads, rolling_line_loads}},
      {"method.trailing_elements",
       "elements behind it",
       {},
       nip_scene,
       {elastic_line_loads, rolling_line_loads}},
      {"method.residue_terms",
       "terms of the residue series",
       {},
       nip_scene,
       {elastic_line_loads, rolling_line_loads}},
      {"method.approach_lengths",
       "half-thicknesses before the nip at which the motion starts",
       {},
       nip_scene,
       {rolling_line_loads}},
      {"profile.points", "number of evenly spaced positions"},
      {"profile.positions",
       "positions along the sheet or along the line; on a half-space without a line, directions in degrees",
       of_length},  // on a half-space without a line they are degrees
      {"profile.direction", "direction of the line on the half-space, degrees", {}, half_space_scene},
      {"field.positions", "positions along the sheet", of_length, nip_scene},
      {"field.depths", "depths over half the thickness, 0 is the middle plane", {}, nip_scene},
      {"sweep.points", "values of each range of the sweep"},
  };
  return keys;
}

const SceneKey* find_scene_key(std::string_view name) {
  const auto found = std::ranges::find(scene_keys(), name, &SceneKey::name);
  return found == scene_keys().end() ? nullptr : &*found;
}

std::vector<std::string_view> names_in_table(std::string_view table, SceneKind kind,
                                             std::optional<KeyOwner> owner) {
  std::vector<std::string_view> names;
  for (const SceneKey& key : scene_keys()) {
    if (key.kind.value_or(kind) != kind) continue;
    if (table.empty()) {
      const std::string_view name = key.table().empty() ? key.name : key.table();
      if (names.empty() || names.back() != name) names.push_back(name);
    } else if (key.table() == table &&
               (key.owners.empty() || (owner && std::ranges::count(key.owners, *owner) > 0))) {
      names.push_back(key.last());
    }
  }
  return names;
}

}  // namespace nipref::data
