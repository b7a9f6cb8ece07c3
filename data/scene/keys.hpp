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
      false;  ///< the unit of each number has one more power of time than the one before
  double least = -std::numeric_limits<double>::infinity(),
         most = -least;                           ///< ends of the domain of its numbers
  std::string allowed = {};                       ///< what a number must be; empty for a magnitude
  std::vector<std::string_view> choices[2] = {};  ///< for a nip, and for a half-space
  std::optional<SceneKind> kind = {};             ///< the kind of scenes that have the key; empty: all
  std::vector<std::string_view> models = {};      ///< the models or methods that have it; empty: all

  [[nodiscard]] std::string_view table() const;  ///< empty above all tables
  [[nodiscard]] std::string_view last() const;   ///< the name without its table
  [[nodiscard]] const std::vector<std::string_view>& choices_of(SceneKind scene) const;
  /// allowed_type() is the requirement for the type of the value. refusal_of() is the requirement that a number outside
  /// the domain violates, and empty for a number in the domain.
  [[nodiscard]] std::string_view allowed_type() const;
  [[nodiscard]] std::string_view refusal_of(double value) const;
};

/// All keys, in the order in which refusals list them. The reader of scenes accepts these and no others.
[[nodiscard]] const std::vector<SceneKey>& scene_keys();

/// The key of this name, or null. An element of a list, "wanted[1]", has the key of the list.
[[nodiscard]] const SceneKey* find_scene_key(std::string_view name);

/// The names that a table may hold in scenes of this kind with this model or method. If `table` is empty: the keys
/// above all tables and the names of the tables.
[[nodiscard]] std::vector<std::string_view> names_in_table(std::string_view table, SceneKind kind,
                                                           std::string_view model = {});

}  // namespace nipref::data
