#pragma once
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/data/scene/results.hpp>

namespace nipref::data {

/// Exponents of length, stress and time.
struct Dimension {
  int length = 0, stress = 0, time = 0;

  [[nodiscard]] std::string text() const;  ///< "length^2 stress"; "1" if all exponents are 0
};

/// The type of a key's value.
enum class KeyType { text, texts, choice, number, numbers, whole };

/// A key of a scene's TOML file, from keys.table.
struct SceneKey {
  std::string_view name;  ///< "TABLE.KEY", or "KEY" above all tables
  std::string_view meaning;
  KeyType type = KeyType::text;
  Dimension dimension = {};
  bool time_grows_along_list =
      false;  ///< each number of the list has one power of time more than that before
  double least = -std::numeric_limits<double>::infinity(),
         most = -least;                           ///< ends of the domain of its numbers
  std::string allowed = {};                       ///< what a number must be; empty for a magnitude
  std::vector<std::string_view> choices[2] = {};  ///< of a nip, and of a half-space
  std::optional<SceneKind> kind = {};             ///< of the scenes that have it; none: all
  std::vector<std::string_view> models = {};      ///< or methods that have it; none: all

  [[nodiscard]] std::string_view table() const;  ///< empty above all tables
  [[nodiscard]] std::string_view last() const;   ///< the name without its table
  [[nodiscard]] const std::vector<std::string_view>& choices_of(SceneKind scene) const;
  /// The requirement that a value of another type is refused with, and a number outside the domain; the latter is empty
  /// for a number in the domain.
  [[nodiscard]] std::string_view allowed_type() const;
  [[nodiscard]] std::string_view refusal_of(double value) const;
};

/// All keys, in the order in which refusals list them. The reader of scenes accepts these and no others.
[[nodiscard]] const std::vector<SceneKey>& scene_keys();

/// Null if no key has this name. An element of a list, "wanted[1]", is found by its list.
[[nodiscard]] const SceneKey* find_scene_key(std::string_view name);

/// The names that a table may hold in such a scene, of this model or method; above all tables (`table` empty) these
/// include the tables.
[[nodiscard]] std::vector<std::string_view> names_in_table(std::string_view table, SceneKind kind,
                                                           std::string_view model = {});

}  // namespace nipref::data
