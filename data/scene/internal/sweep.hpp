#pragma once
#include <nipref/data/scene/internal/toml_table.hpp>
#include <nipref/data/scene/sweep.hpp>

namespace nipref::data {

/// The table [sweep] of a whole scene, if it has one. `origin` is that of the scene.
SceneSweep read_sweep(const TomlTable& file, const SceneOrigin& origin);

}  // namespace nipref::data
