#pragma once
#include <span>
#include <string_view>

namespace nipref::data {

/// What a scene is about.
enum class SceneKind { nip, half_space };

/// Where a result of a nip is defined.
enum class Needs {
  nothing,
  converged,        ///< the converged method
  shear,            ///< full friction: without it there is none
  line_load_creep,  ///< line loads with full friction
};

/// How many numbers a result is.
enum class Shape {
  number,   ///< one
  list,     ///< as many as there are, one at least
  profile,  ///< one at each position along the sheet, or in each direction on the half-space
  field     ///< one at each place of the scene's field, depth after depth
};

/// Everything that a scene can want, in the order of scene_results(), called there what it is called here.
enum class ResultId {
  contact_length,
  leading_length,
  trailing_length,
  load,
  indentation,
  edge_displacement,
  trailing_displacement,
  rolling_resistance,
  eccentricity,
  resistance_force,
  power_loss,
  leading_moment,
  trailing_moment,
  creep_ratio,
  creep_range,
  peak_pressure,
  peak_pressure_position,
  peak_shear,
  peak_shear_position,
  shear_zeros,
  span_along,
  span_across,
  span_ratio,
  axis_ratio,
  orientation,
  approach,
  normal_force,
  friction_force,
  centre_along,
  centre_across,
  critical_speed,
  greatest_shear,
  greatest_shear_position,
  greatest_shear_depth,
  stress_across,
  stress_along,
  stress_shear,
  highest_stress,
  lowest_stress,
  maximum_shear,
  pressure,
  shear,
  normal_displacement,
  tangential_displacement,
  surface_strain,
  slip,
  span,
  leading_end,
  trailing_end,
  creep,
  compressed_radius,
  compliance,
  coupling,
};

struct SceneResult {
  ResultId id;
  std::string_view name;
  std::string_view unit;  ///< in the scene's own units: "length", "force/length", "stress", "1" and so on
  std::string_view meaning;
  Shape shape = Shape::number;
  SceneKind kind = SceneKind::nip;
  bool in_every_scene = false;
  bool is_inside = false;  ///< of the stresses inside the sheet, which the converged method has
  Needs needs = Needs::nothing;

  [[nodiscard]] bool is_of(SceneKind other) const { return in_every_scene || kind == other; }
};

/// All of them, the profiles last.
[[nodiscard]] std::span<const SceneResult> scene_results();

/// The one called `name`, or nullptr.
[[nodiscard]] const SceneResult* find_scene_result(std::string_view name);

[[nodiscard]] const SceneResult& scene_result(ResultId id);

}  // namespace nipref::data
