#pragma once
#include <memory>
#include <variant>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/scene/scene.hpp>
#include <nipref/fast/number/estimate.hpp>
#include <nipref/ref/half_space/joint_response.hpp>
#include <nipref/ref/number/estimate.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>

namespace nipref::verify {

// A contact solved by each method of a scene, with all its results. BadInput that names "load" or "contact_length" if
// the contact's length is not allowed.

using SolvedInDouble = std::unique_ptr<SolvedContact<fast::Estimate>>;
using SolvedByRef = std::unique_ptr<SolvedContact<ref::Estimate>>;

/// Calls for_load or for_length with the number that the scene gives.
template <class ForLoad, class ForLength>
auto solve_given(const data::Given& given, const ForLoad& for_load, const ForLength& for_length) {
  const auto* const load = std::get_if<data::GivenLoad>(&given);
  return load != nullptr ? for_load(load->per_length)
                         : for_length(std::get<data::GivenLength>(given).contact_length);
}

/// The continuous contact in double; `accuracy` is the scene's.
SolvedInDouble solve_converged(const data::ElasticNipProblem& problem, double accuracy);
SolvedInDouble solve_converged(const data::ViscoelasticNipProblem& problem, double accuracy);

/// Line loads in double. The error of a result is its distance to the same result of the continuous contact, solved to
/// 1e-5, whose own error is added. The kernels of those of a rolling nip are exact to rounding, or the truncated series
/// that the scene asks for.
SolvedInDouble solve_line_loads(const data::ElasticNipProblem& problem, const data::LineLoads& loads,
                                double accuracy);
SolvedInDouble solve_line_loads(const data::ViscoelasticNipProblem& problem,
                                const data::ViscoelasticLineLoads& loads, double accuracy);

/// A body on a half-space in double. BadInput "speed" unless the speed is subcritical on every line.
SolvedInDouble solve_half_space(const data::HalfSpaceProblem& problem);

/// The continuous contact by the reference. The errors are proven bounds for much of what elastic and rolling nips have
/// (ref/README.md, What is proven), otherwise estimates.
SolvedByRef solve_ref_converged(const data::ElasticNipProblem& problem, int digits);
SolvedByRef solve_ref_converged(const data::ViscoelasticNipProblem& problem, int digits);

/// Line loads by the reference. The errors are proven bounds.
SolvedByRef solve_ref_line_loads(const data::ElasticNipProblem& problem, const data::LineLoads& loads,
                                 int digits);
SolvedByRef solve_ref_line_loads(const data::ViscoelasticNipProblem& problem,
                                 const data::ViscoelasticLineLoads& loads, int digits);

/// A body on a half-space by the reference: the errors of the response of a line and, where all lines are alike, of the
/// critical speed are proven bounds, those of the contact are estimates. BadInput "digits" if the digits cannot be
/// reached, "span" if the span of a rolling sphere is too large.
SolvedByRef solve_ref_half_space(const ref::JointResponse& surface, const data::HalfSpaceProblem& problem,
                                 int digits);

/// Throws the solver's error again and names the key of the scene's load or length: Scene::check has accepted the
/// scene, so that the solver can refuse it only because of their values, the material, or the digits.
[[noreturn]] void refuse_given(const data::Scene& scene, const data::Given& given,
                               const data::BadInput& error);
/// Refuses the scene's load or length because the rollers' faces would meet.
[[noreturn]] void refuse_meeting_faces(const data::Scene& scene, const data::Given& given, double indentation,
                                       double half_thickness);

}  // namespace nipref::verify
