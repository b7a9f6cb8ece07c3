#pragma once
#include <memory>

#include <nipref/data/scene/scene.hpp>
#include <nipref/fast/number/estimate.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>

namespace nipref::verify {

/// A body on a half-space in double. BadInput, naming the scene's key and its place, for a speed that is not
/// subcritical on every line and for results that the method does not have.
std::unique_ptr<SolvedContact<fast::Estimate>> solve_half_space(const data::Scene& scene,
                                                                const data::HalfSpaceProblem& problem);

}  // namespace nipref::verify
