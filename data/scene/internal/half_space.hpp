#pragma once
#include <nipref/data/problem/half_space.hpp>
#include <nipref/data/scene/internal/toml_table.hpp>
#include <nipref/data/scene/origin.hpp>

namespace nipref::data {

/// Reads a scene about a half-space. BadInput that names the key.
[[nodiscard]] HalfSpaceProblem read_half_space_problem(const TomlTable& file, const SceneOrigin& origin);

}  // namespace nipref::data
