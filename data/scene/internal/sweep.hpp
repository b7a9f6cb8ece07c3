#pragma once
#include <nipref/data/scene/internal/toml_table.hpp>
#include <nipref/data/scene/sweep.hpp>

namespace nipref::data {

/// What a whole scene's table [sweep] says, if it has one. `origin` is the table's.
SceneSweep read_sweep(const TomlTable& file, const SceneOrigin& origin);

}  // namespace nipref::data
