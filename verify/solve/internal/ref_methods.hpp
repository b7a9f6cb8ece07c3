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

// A contact solved by the reference. BadInput naming "load" or "contact_length" if its value is not allowed.

/// The errors are proven bounds without friction and estimates with it.
std::unique_ptr<SolvedContact<ref::Estimate>> solve_ref_converged(const data::ElasticNipProblem& problem,
                                                                  int digits);

/// The errors are proven bounds.
std::unique_ptr<SolvedContact<ref::Estimate>> solve_ref_line_loads(const data::ElasticNipProblem& problem,
                                                                   const data::LineLoads& loads, int digits);

/// The errors are estimates.
std::unique_ptr<SolvedContact<ref::Estimate>> solve_ref_rolling(const data::ViscoelasticNipProblem& problem,
                                                                int digits);

/// The errors are estimates.
std::unique_ptr<SolvedContact<ref::Estimate>> solve_ref_rolling_line_loads(
    const data::ViscoelasticNipProblem& problem, const data::ViscoelasticLineLoads& loads, int digits);

/// A body on a half-space: the errors of the response of a line and, where all lines are alike, of the critical speed
/// are proven bounds, those of the contact are estimates. A result is computed when it is first asked for. BadInput
/// "digits" if the digits cannot be reached, "span" if the span of a rolling sphere is too large.
std::unique_ptr<SolvedContact<ref::Estimate>> solve_ref_half_space(const RefSurface& surface,
                                                                   const data::HalfSpaceProblem& problem,
                                                                   int digits);

}  // namespace nipref::verify
