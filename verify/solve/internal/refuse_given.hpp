#pragma once
#include <nipref/data/bad_input.hpp>
#include <nipref/data/scene/scene.hpp>

namespace nipref::verify {

/// Throws the solver's error again and names the key of the scene's load or length: Scene::check has accepted the
/// scene, so that the solver can refuse it only because of their values, the material, or the digits.
[[noreturn]] void refuse_given(const data::Scene& scene, const data::Given& given,
                               const data::BadInput& error);
/// Refuses the scene's load or length because the rollers' faces would meet.
[[noreturn]] void refuse_meeting_faces(const data::Scene& scene, const data::Given& given, double indentation,
                                       double half_thickness);

}  // namespace nipref::verify
