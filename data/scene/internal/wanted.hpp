#pragma once
#include <string>
#include <vector>

#include <nipref/data/scene/scene.hpp>

namespace nipref::data {

/// The results with these names. BadInput, with the nearest names, for an unknown one.
std::vector<ResultId> read_wanted(const std::vector<std::string>& names, SceneKind kind,
                                  const SceneOrigin& origin);

/// Refuses results that the scene cannot have or wants twice. Returns whether a profile is wanted.
bool check_wanted(const Scene& scene);

}  // namespace nipref::data
