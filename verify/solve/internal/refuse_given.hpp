#pragma once
#include <nipref/data/bad_input.hpp>
#include <nipref/data/scene/scene.hpp>

namespace nipref::verify {

/// Throws what a solver refused again, naming the scene's key. The scene itself being in order, it is where
/// the load or the length leads.
[[noreturn]] void refuse_given(const data::Scene& scene, const data::Given& given,
                               const data::BadInput& error);
/// The same of a rolling nip, whose material and digits can be refused too.
[[noreturn]] void refuse_rolling(const data::Scene& scene, const data::ViscoelasticNipProblem& problem,
                                 const data::BadInput& error);
/// Refuses what was given since the rollers' faces would meet.
[[noreturn]] void refuse_meeting_faces(const data::Scene& scene, const data::Given& given, double indentation,
                                       double half_thickness);

}  // namespace nipref::verify
