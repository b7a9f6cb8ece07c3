#pragma once
#include <string>
#include <string_view>

#include <nipref/data/problem/half_space.hpp>
#include <nipref/data/scene/origin.hpp>
#include <nipref/data/scene/results.hpp>

namespace nipref::data {

/// Throws BadInput naming the key and its place unless every value is in its domain. Whether the speed is
/// subcritical is for the solvers to find out.
void check_half_space_problem(const HalfSpaceProblem& problem, const SceneOrigin& origin);

/// Refuses a result, wanted as `key`, that the problem's method does not have.
void check_half_space_wanted(const HalfSpaceProblem& problem, const SceneResult& result, std::string_view key,
                             const SceneOrigin& origin);

}  // namespace nipref::data
