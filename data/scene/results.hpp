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
  inside,           ///< nothing: it is a stress inside the sheet
  inside_elastic,   ///< an elastic sheet that does not roll: displacements inside the sheet
  inside_all,       ///< the converged method: the largest stress inside the sheet
  shear,            ///< full friction: without friction there is no shear
  line_load_creep,  ///< line loads with full friction
  partial_slip,     ///< Coulomb's friction
  slip_heat,        ///< Coulomb's friction and the converged method
};

/// How many numbers a result has.
enum class Shape {
  number,   ///< one
  list,     ///< as many as there are, one at least
  profile,  ///< one at each position along the sheet, or in each direction on the half-space
  field     ///< one at each place of the field: all positions at the first depth, then at the next
};

/// The least size against which the error of a result is measured, in the unit of the result. A scene asks for a
/// relative accuracy, but a result that may be 0 has no relative error: the accuracy is met if the error is at most the
/// accuracy times the larger of the result's magnitude and this size. A traction grows from an end of the contact like
/// a square root. Next to an end its size is larger, so that the accuracy allows for the change by a shift of that end
/// by the accuracy times L/2. There is an enumerator for each row of scales.table; text() describes it.
enum class Scale {
#include <nipref/scene_scales.inc>
};

/// The size in words, where L is the length of the contact and R the radius of the roller. On a half-space "the
/// pressure in the middle" means the largest pressure.
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
  std::optional<SceneKind> kind = {};  ///< the kind of scenes that have it; empty: all
  Needs needs = Needs::nothing;

  [[nodiscard]] bool is_inside() const { return needs >= Needs::inside && needs <= Needs::inside_all; }

  /// Whether its profile on a half-space is along the line of the scene, and not over directions.
  [[nodiscard]] bool is_along_line() const {
    return kind != SceneKind::half_space || id == ResultId::transverse_displacement;
  }

  [[nodiscard]] bool is_of(SceneKind scene) const { return kind.value_or(scene) == scene; }
};

/// All results, the profiles last.
[[nodiscard]] std::span<const SceneResult> scene_results();

/// The result called `name`, or nullptr.
[[nodiscard]] const SceneResult* find_scene_result(std::string_view name);

[[nodiscard]] const SceneResult& scene_result(ResultId id);

}  // namespace nipref::data
