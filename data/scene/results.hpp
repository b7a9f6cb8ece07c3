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

/// Something that a scene can want.
struct SceneResult {
  std::string_view name;
  std::string_view unit;  ///< in the scene's own units: "length", "force/length", "stress", "1" and so on
  std::string_view meaning;
  bool is_profile;  ///< one number at each position along the sheet, or in each direction on the half-space
  SceneKind kind = SceneKind::nip;
  bool in_every_scene = false;
  bool is_field = false;      ///< one number at each place of the scene's field, depth after depth
  bool is_inside = is_field;  ///< of the stresses inside the sheet, which the converged method has
  bool is_list = false;       ///< as many numbers as there are, one at least
  Needs needs = Needs::nothing;

  [[nodiscard]] bool is_of(SceneKind other) const { return in_every_scene || kind == other; }
};

/// All of them, the profiles last.
[[nodiscard]] std::span<const SceneResult> scene_results();

/// The one called `name`, or nullptr.
[[nodiscard]] const SceneResult* find_scene_result(std::string_view name);

}  // namespace nipref::data
