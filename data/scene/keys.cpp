#include <algorithm>

#include <nipref/data/scene/keys.hpp>

namespace nipref::data {
namespace {

constexpr Dimension of_length{1, 0, 0}, of_stress{0, 1, 0}, of_time{0, 0, 1}, of_rate{0, 0, -1};
constexpr Dimension of_speed{1, 0, -1}, of_density{-2, 1, 2}, of_viscosity{0, 1, 1};
constexpr Dimension of_compliance{0, -1, 0}, of_compliance_rate{0, -1, -1};
constexpr auto nips = SceneKind::nip, half_spaces = SceneKind::half_space;
using enum KeyOwner;

}  // namespace

std::string_view SceneKey::table() const {
  const std::size_t dot = name.find('.');
  return dot == std::string_view::npos ? std::string_view{} : name.substr(0, dot);
}

std::string_view SceneKey::last() const { return name.substr(name.find('.') + 1); }

const std::vector<SceneKey>& scene_keys() {
  static const std::vector<SceneKey> keys{
      {"title"},
      {"wanted"},
      {"accuracy"},
      {"roller.radius", of_length, nips},
      {"sheet.thickness", of_length, nips},
      {"material.model", {}, nips},
      {"material.young", of_stress, nips, {elastic_solid}},
      {"material.poisson", {}, nips, {elastic_solid}},
      {"material.bulk", of_stress, nips, {one_relaxation_time}},
      {"material.shear", of_stress, nips, {one_relaxation_time}},
      {"material.relaxation_time", of_time, nips, {one_relaxation_time, six_constants}},
      {"material.shear_1", of_stress, nips, {six_constants}},
      {"material.shear_2", of_stress, nips, {six_constants}},
      {"material.bulk_1", of_stress, nips, {six_constants}},
      {"material.bulk_2", of_stress, nips, {six_constants}},
      {"material.shear_viscosity", of_viscosity, nips, {six_constants}},
      {"material.bulk_viscosity", of_viscosity, nips, {six_constants}},
      {"material.theta1_instantaneous", of_compliance, nips, {prony}},
      {"material.theta1_amplitudes", of_compliance_rate, nips, {prony}},
      {"material.theta1_rates", of_rate, nips, {prony}},
      {"material.theta2_instantaneous", of_compliance, nips, {prony}},
      {"material.theta2_amplitudes", of_compliance_rate, nips, {prony}},
      {"material.theta2_rates", of_rate, nips, {prony}},
      {"material.P", {}, nips, {operators}, true},
      {"material.Q", of_stress, nips, {operators}, true},
      {"material.P_dilatation", {}, nips, {operators}, true},
      {"material.Q_dilatation", of_stress, nips, {operators}, true},
      {"half_space.model", {}, half_spaces},
      {"half_space.shear", of_stress, half_spaces, {isotropic}},
      {"half_space.poisson", {}, half_spaces, {isotropic}},
      {"half_space.stiffness", of_stress, half_spaces, {anisotropic}},
      {"half_space.axis", {}, half_spaces, {transversely_isotropic}},
      {"half_space.c11", of_stress, half_spaces, {transversely_isotropic}},
      {"half_space.c33", of_stress, half_spaces, {transversely_isotropic}},
      {"half_space.c13", of_stress, half_spaces, {transversely_isotropic}},
      {"half_space.c44", of_stress, half_spaces, {transversely_isotropic}},
      {"half_space.c66", of_stress, half_spaces, {transversely_isotropic}},
      {"half_space.density", of_density, half_spaces},
      {"die.radius_along", of_length, half_spaces},
      {"die.radius_across", of_length, half_spaces},
      {"rolling_sphere.radius", of_length, half_spaces},
      {"sphere.radius", of_length, half_spaces},
      {"sphere.shear", of_stress, half_spaces},
      {"sphere.poisson", {}, half_spaces},
      {"sphere.density", of_density, half_spaces},
      {"sphere.patch", {}, half_spaces},
      {"sliding.speed", of_speed, half_spaces},
      {"sliding.direction", {}, half_spaces},
      {"sliding.friction", {}, half_spaces},
      {"rolling.speed", of_speed},
      {"load.per_length", {1, 1, 0}, nips},
      {"load.normal_force", {2, 1, 0}, half_spaces},
      {"contact.length", of_length, nips},
      {"contact.span_along", of_length, half_spaces},
      {"friction.model", {}, nips},
      {"friction.creep_ratio", {}, nips, {elastic_nip}},
      {"method.kind"},
      {"method.leading_elements", {}, nips, {elastic_line_loads, rolling_line_loads}},
      {"method.trailing_elements", {}, nips, {elastic_line_loads, rolling_line_loads}},
      {"method.residue_terms", {}, nips, {elastic_line_loads, rolling_line_loads}},
      {"method.approach_lengths", {}, nips, {rolling_line_loads}},
      {"profile.points"},
      {"profile.positions", of_length},  // on a half-space without a line they are degrees
      {"profile.direction", {}, half_spaces},
      {"field.positions", of_length, nips},
      {"field.depths", {}, nips},
      {"sweep.points"},
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
