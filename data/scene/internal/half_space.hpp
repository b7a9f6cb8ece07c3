#pragma once
#include <nipref/data/problem/half_space.hpp>
#include <nipref/data/scene/internal/toml_table.hpp>
#include <nipref/data/scene/origin.hpp>

namespace nipref::data {

/// A scene about a half-space: what else may stand in it, and what stands there. BadInput naming the key.
[[nodiscard]] HalfSpaceProblem read_half_space_problem(const TomlTable& file, const SceneOrigin& origin);

}  // namespace nipref::data
