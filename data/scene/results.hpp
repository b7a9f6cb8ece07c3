#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nipref::data {

/// What a scene is about.
enum class SceneKind { nip, half_space };

/// What a scene must have for a result of its nip to be defined.
enum class Needs {
  nothing,
  converged,        ///< the converged method
  inside,           ///< the converged method: stresses inside the sheet
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

/// The least size against which the error of a result is measured, in the result's unit. A scene asks for a relative
/// accuracy, and a result that may be 0 has no relative error: the accuracy is met where the error is at most the
/// accuracy times the larger of the result's magnitude and this size. L is the contact's length, R the roller's radius,
/// p0 the pressure in the middle of the contact, on a half-space the largest pressure. A traction grows from an end of
/// the contact like a square root: next to an end its size is so much larger that the accuracy allows what moving that
/// end by the accuracy times L/2 changes.
enum class Scale {
  itself,                   ///< 0: the error is measured against the result alone
  half_contact,             ///< L/2
  half_contact_times_load,  ///< L/2 times the load
  hundred_half_contacts,    ///< 50 L: a traction's slope is known less well than the traction
  roller_rise,              ///< (L/2)^2/(2R), the rise of the roller's parabola over L/2
  creep,                    ///< L/(4R)
  creep_next_to_end,        ///< the same, larger next to an end
  distance_times_creep,     ///< L/(4R) times |Y|, outside the contact times L/2
  pressure,                 ///< p0, larger next to an end
  shear,                    ///< p0/10, on a half-space p0, larger next to an end
  tenth_of_pressure,        ///< p0/10
  flat_maximum_depth,       ///< allows 1e-6 + 10 sqrt(accuracy), as a maximum is flat at its place
  flat_maximum,             ///< L/2 times that
  rounding_of_slope,        ///< L/(2R), but it allows no more than rounding, 1e-14 L/(2R)
  rolling_resistance,       ///< the same times the other factors of the product
  radian,                   ///< one radian in degrees
  span_along,               ///< extent of the contact along the motion
  compliance,               ///< compliance of the same line
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
  Scale scale = Scale::itself;
  Shape shape = Shape::number;
  std::optional<SceneKind> kind = SceneKind::nip;  ///< the scenes that have it; none: all
  Needs needs = Needs::nothing;

  [[nodiscard]] bool is_of(SceneKind scene) const { return kind.value_or(scene) == scene; }
};

/// All of them, the profiles last.
[[nodiscard]] std::span<const SceneResult> scene_results();

/// The one called `name`, or nullptr.
[[nodiscard]] const SceneResult* find_scene_result(std::string_view name);

[[nodiscard]] const SceneResult& scene_result(ResultId id);

}  // namespace nipref::data
