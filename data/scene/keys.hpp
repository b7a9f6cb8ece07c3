#pragma once
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

/// The models and methods that have keys of their own.
enum class KeyOwner {
  elastic_nip,
  elastic_solid,
  one_relaxation_time,
  six_constants,
  prony,
  operators,
  elastic_line_loads,
  rolling_line_loads,
  isotropic,
  transversely_isotropic,
  anisotropic,
};

/// A key of a scene's TOML file.
struct SceneKey {
  std::string_view name;  ///< "TABLE.KEY", or "KEY" above all tables
  std::string_view meaning;
  Dimension dimension = {};
  std::optional<SceneKind> kind = {};  ///< the scenes that have it; none: all
  std::vector<KeyOwner> owners = {};   ///< none: the key does not depend on models and methods
  bool time_grows_along_list =
      false;  ///< each number of the list has one power of time more than the number before

  [[nodiscard]] std::string_view table() const;  ///< empty above all tables
  [[nodiscard]] std::string_view last() const;   ///< the name without its table
};

/// All keys, in the order in which refusals list them. The reader of scenes accepts these and no others.
[[nodiscard]] const std::vector<SceneKey>& scene_keys();

/// Null if no key has this name.
[[nodiscard]] const SceneKey* find_scene_key(std::string_view name);

/// The names that a table may hold in such a scene; above all tables (`table` empty) these include the tables.
[[nodiscard]] std::vector<std::string_view> names_in_table(std::string_view table, SceneKind kind,
                                                           std::optional<KeyOwner> owner = {});

}  // namespace nipref::data
