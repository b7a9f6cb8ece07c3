#pragma once
#include <nipref/data/scene/file.hpp>
#include <nipref/data/scene/scene.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/scratch_file.hpp"
#include "support/test.hpp"

/// The scene of this text, solved.
inline nipref::verify::SceneSolution<nipref::fast::Estimate> solved(const std::string& text) {
  const ScratchFile file(text);
  return nipref::verify::solve(nipref::data::load_scene(file.path()));
}

/// All that every scene of a nip can want: the stresses inside the sheet not every method has, nor what comes of shear.
inline std::vector<nipref::data::ResultId> all_results() {
  std::vector<nipref::data::ResultId> results;
  for (const nipref::data::SceneResult& result : nipref::data::scene_results()) {
    if (result.is_of(nipref::data::SceneKind::nip) && result.needs == nipref::data::Needs::nothing)
      results.push_back(result.id);
  }
  return results;
}

inline nipref::data::ElasticNipProblem& problem_of(nipref::data::Scene& scene) {
  return std::get<nipref::data::ElasticNipProblem>(scene.system);
}
