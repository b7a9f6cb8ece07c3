#pragma once
#include <nipref/data/scene/scene.hpp>

// The parts of Scene::check(). They throw BadInput that names the key and its place.

namespace nipref::data {

/// Checks that there are 2 to 10000 points, or 1 to 10000 positions that are all finite.
void check_profile(const Profile& profile, const SceneOrigin& origin);
/// Checks that there are 1 to 100000 places and that every number is in its domain.
void check_field(const FieldPlaces& field, const SceneOrigin& origin);
/// Checks that every value is in its domain. The solvers find out whether the speed is subcritical.
void check_half_space_problem(const HalfSpaceProblem& problem, const SceneOrigin& origin);
/// Refuses results that the scene cannot have or wants twice. Returns whether a profile is wanted.
bool check_wanted(const Scene& scene);

}  // namespace nipref::data
