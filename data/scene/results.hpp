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
  inside,           ///< nothing: stresses inside the sheet
  inside_elastic,   ///< an elastic sheet that does not roll: displacements inside the sheet
  inside_all,       ///< the converged method: the largest stress inside the sheet
  shear,            ///< full friction: without it there is none
  line_load_creep,  ///< line loads with full friction
  partial_slip,     ///< Coulomb's friction
  slip_heat,        ///< the same, and the converged method
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
/// accuracy times the larger of the result's magnitude and this size. A traction grows from an end of the contact like a
/// square root: next to an end its size is so much larger that the accuracy allows what moving that end by the accuracy times
/// L/2 changes. An enumerator for each row of scales.table; text() has what it is.
enum class Scale {
#include <nipref/scene_scales.inc>
};

/// In words, L the contact's length, R the roller's radius. The pressure in the middle of a contact on a half-space is the
/// largest.
[[nodiscard]] std::string_view text(Scale scale);

/// Everything that a scene can want: an enumerator for each row of results.table.
enum class ResultId {
#include <nipref/scene_results.inc>
};

/// A row of results.table.
struct SceneResult {
  ResultId id;
  std::string_view name;
  std::string_view unit;  ///< in the scene's own units: "length", "force/length", "stress", "1" and so on
  std::string_view meaning;
  Scale scale = Scale::itself;
  Shape shape = Shape::number;
  std::optional<SceneKind> kind = {};  ///< the scenes that have it; none: all
  Needs needs = Needs::nothing;

  [[nodiscard]] bool is_inside() const { return needs >= Needs::inside && needs <= Needs::inside_all; }

  /// Whether its profile on a half-space is along the scene's line, else over directions.
  [[nodiscard]] bool is_along_line() const {
    return kind != SceneKind::half_space || id == ResultId::transverse_displacement;
  }

  [[nodiscard]] bool is_of(SceneKind scene) const { return kind.value_or(scene) == scene; }
};

/// All of them, the profiles last.
[[nodiscard]] std::span<const SceneResult> scene_results();

/// The one called `name`, or nullptr.
[[nodiscard]] const SceneResult* find_scene_result(std::string_view name);

[[nodiscard]] const SceneResult& scene_result(ResultId id);

}  // namespace nipref::data
