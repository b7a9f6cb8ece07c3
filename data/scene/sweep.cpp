#include <nipref/data/scene/internal/read.hpp>

namespace nipref::data {
namespace {

/// Reads the keys of [sweep] or of a table in it. `above`: what stands before the keys, "load." or nothing.
void read_keys(const SceneTable& table, const std::string& above, SceneSweep& sweep) {
  for (const std::string& key : table.keys()) {
    if (above.empty() && key == "points") {
      sweep.points = table.whole(key);
    } else if (table.has_table(key)) {
      read_keys(table.any_table(key), above + key + ".", sweep);
    } else {
      sweep.keys.emplace_back(above + key, table.text_or_list(key));
    }
  }
}

}  // namespace

SceneSweep read_sweep(const SceneTable& file, const SceneOrigin& origin) {
  SceneSweep sweep;
  if (file.has("sweep")) read_keys(file.any_table("sweep"), "", sweep);
  if (sweep.points) origin.check_domain("sweep.points", *sweep.points);
  return sweep;
}

SceneSweep scene_sweep(const SceneText& scene) {
  SceneOrigin origin(scene.name);
  return read_sweep(SceneTable::parse(scene.toml, origin, {}), origin);
}

}  // namespace nipref::data
