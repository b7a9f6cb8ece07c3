#pragma once
#include <memory>
#include <string_view>
#include <vector>

#include <nipref/data/scene/scene.hpp>
#include <nipref/ref/number/estimate.hpp>
#include <nipref/verify/solve/internal/ref_surface.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {

// A contact solved by the reference. BadInput naming "load" or "contact_length" if that is not allowed.

/// Proven without friction, estimated with it.
std::unique_ptr<SolvedContact<ref::Estimate>> solve_ref_converged(const data::ElasticNipProblem& problem,
                                                                  int digits);

/// Proven.
std::unique_ptr<SolvedContact<ref::Estimate>> solve_ref_line_loads(const data::ElasticNipProblem& problem,
                                                                   const data::LineLoads& loads, int digits);

/// Estimated.
std::unique_ptr<SolvedContact<ref::Estimate>> solve_ref_rolling(const data::ViscoelasticNipProblem& problem,
                                                                int digits);

/// Estimated.
std::unique_ptr<SolvedContact<ref::Estimate>> solve_ref_rolling_line_loads(
    const data::ViscoelasticNipProblem& problem, const data::ViscoelasticLineLoads& loads, int digits);

/// A body on a half-space: line answers and, where all lines are alike, the critical speed are proven, contacts
/// estimated. Nothing is computed before it is asked for. BadInput "digits" where the digits are not reached,
/// "span" where a rolling sphere's is too large.
std::unique_ptr<SolvedContact<ref::Estimate>> solve_ref_half_space(const RefSurface& surface,
                                                                   const data::HalfSpaceProblem& problem,
                                                                   int digits);

}  // namespace nipref::verify
