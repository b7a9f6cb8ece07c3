#pragma once
#include <nipref/data/scene/internal/toml_table.hpp>
#include <nipref/data/scene/sweep.hpp>

namespace nipref::data {

/// What a whole scene's table [sweep] says, if it has one.
SceneSweep read_sweep(const TomlTable& file);

}  // namespace nipref::data
