#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nipref/data/scene/file.hpp>

namespace nipref::data {

/// What the table [sweep] of a scene's file says: which keys take which values, for a contact of each combination.
///
///     [sweep]  load.per_length = [50, 100, 200] or "1..1000:log", any other key of the scene likewise
///              points: values of each range, 1 to 1e7, optional
struct SceneSweep {
  /// {"load.per_length", "50, 100, 200" or "1..1000:log"}, in the order of the alphabet.
  std::vector<std::pair<std::string, std::string>> keys;
  std::optional<int> points;
};

/// Without keys if the file has no such table. BadInput "FILE:LINE: KEY = VALUE: ALLOWED" for what is no
/// TOML, and for values that are neither a text nor a list of numbers or texts.
[[nodiscard]] SceneSweep scene_sweep(const SceneText& scene);

}  // namespace nipref::data
