#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nipref/data/scene/file.hpp>

namespace nipref::data {

/// The table [sweep] of a scene's file: the values that keys take. There is a contact for each combination of them.
///
///     [sweep]  load.per_length = [50, 100, 200] or "1..1000:log", any other key of the scene likewise
///              points: values of each range, 1 to 1e7, optional
struct SceneSweep {
  /// {"load.per_length", "50, 100, 200" or "1..1000:log"}, in the order of the alphabet.
  std::vector<std::pair<std::string, std::string>> keys;
  std::optional<int> points;
};

/// It has no keys if the file has no such table. BadInput "FILE:LINE: KEY = VALUE: ALLOWED" for what is no
/// TOML, and for values that are neither a text nor a list of numbers or texts.
[[nodiscard]] SceneSweep scene_sweep(const SceneText& scene);

}  // namespace nipref::data
