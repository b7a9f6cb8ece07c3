#pragma once
#include <memory>

#include <nipref/data/scene/scene.hpp>
#include <nipref/fast/number/estimate.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>

namespace nipref::verify {

/// The accuracy of the continuous contact to which line loads are compared; their distance to it is at least about
/// 1e-3.
inline constexpr double truth_accuracy = 1e-5;

// The elastic nip solved in double by each method. `accuracy` is the scene's. BadInput naming "load" or
// "contact_length" if the contact's length is not allowed.

std::unique_ptr<SolvedContact<fast::Estimate>> solve_converged(const data::ElasticNipProblem& problem,
                                                               double accuracy);
std::unique_ptr<SolvedContact<fast::Estimate>> solve_line_loads(const data::ElasticNipProblem& problem,
                                                                const data::LineLoads& loads,
                                                                double accuracy);

// The rolling viscoelastic nip likewise.

std::unique_ptr<SolvedContact<fast::Estimate>> solve_viscoelastic(const data::ViscoelasticNipProblem& problem,
                                                                  double accuracy);
/// This needs no accuracy: the kernels are exact to rounding, or they are the truncated series that the scene asks for.
std::unique_ptr<SolvedContact<fast::Estimate>> solve_viscoelastic_line_loads(
    const data::ViscoelasticNipProblem& problem, const data::ViscoelasticLineLoads& loads);

}  // namespace nipref::verify
