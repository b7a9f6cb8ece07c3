#pragma once
#include <span>
#include <string_view>

namespace nipref::data {

/// Something that a scene can want.
struct SceneResult {
  std::string_view name;
  std::string_view unit;  ///< in the scene's own units: "length", "force/length", "stress" or "1"
  std::string_view meaning;
  bool is_profile;  ///< one number at each position along the sheet
};

/// All of them, the profiles last.
[[nodiscard]] std::span<const SceneResult> scene_results();

/// The one called `name`, or nullptr.
[[nodiscard]] const SceneResult* find_scene_result(std::string_view name);

}  // namespace nipref::data
