#pragma once
#include <string_view>

#include <nipref/data/scene/origin.hpp>

namespace nipref::data {

// What the checks of a scene have in common. Each refuses the value, naming the key and its place.

void require(bool holds, const SceneOrigin& origin, std::string_view key, double value,
             std::string_view allowed);

/// Refuses a number that is not in the domain that scene_keys() has for the key, "field.depths[1]" for a list's.
void check_domain(double value, const SceneOrigin& origin, std::string_view key);

void require_whole(int value, int least, int most, const SceneOrigin& origin, std::string_view key);

}  // namespace nipref::data
