#pragma once
#include <initializer_list>
#include <string_view>

#include <nipref/data/problem/profile.hpp>
#include <nipref/data/scene/internal/toml_table.hpp>
#include <nipref/data/scene/origin.hpp>

namespace nipref::data {

/// The reading of [profile], for all systems; `known`: the keys that it may have. BadInput naming the key.
[[nodiscard]] Profile read_profile(const TomlTable& profile, const SceneOrigin& origin,
                                   std::initializer_list<std::string_view> known = {"points", "positions"});

/// Throws BadInput naming the key and its place unless there are 2 to 10000 points, or as many positions from one on
/// and all of them finite.
void check_profile(const Profile& profile, const SceneOrigin& origin);

}  // namespace nipref::data
