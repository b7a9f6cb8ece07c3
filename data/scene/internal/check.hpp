#pragma once
#include <nipref/data/scene/scene.hpp>

// The parts of Scene::check(). BadInput that names the key and its place.

namespace nipref::data {

/// 2 to 10000 points, or as many positions from one on and all of them finite.
void check_profile(const Profile& profile, const SceneOrigin& origin);
/// 1 to 100000 places, every number in its domain.
void check_field(const FieldPlaces& field, const SceneOrigin& origin);
/// Every value in its domain. Whether the speed is subcritical is for the solvers to find out.
void check_half_space_problem(const HalfSpaceProblem& problem, const SceneOrigin& origin);
/// Refuses results that the scene cannot have or wants twice. Returns whether a profile is wanted.
bool check_wanted(const Scene& scene);

}  // namespace nipref::data
