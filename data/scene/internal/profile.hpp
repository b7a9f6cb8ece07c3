#pragma once
#include <nipref/data/problem/profile.hpp>
#include <nipref/data/scene/internal/toml_table.hpp>
#include <nipref/data/scene/origin.hpp>

namespace nipref::data {

/// Reads [profile] of any scene. Throws BadInput naming the key.
[[nodiscard]] Profile read_profile(const TomlTable& profile, const SceneOrigin& origin, SceneKind kind);

/// Throws BadInput naming the key and its place unless there are 2 to 10000 points, or as many positions from one on
/// and all of them finite.
void check_profile(const Profile& profile, const SceneOrigin& origin);

}  // namespace nipref::data
