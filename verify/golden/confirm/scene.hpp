#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <nipref/data/scene/scene.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::verify {

/// Results of a contact by a second method, in the scene's units.
struct SecondSolution {
  std::string method;
  std::vector<std::pair<data::ResultId, ref::Estimate>> numbers;
};

/// Solves the scene by a second method; empty if none reaches such a contact.
std::function<SecondSolution()> second_solver(const data::Scene& scene);

}  // namespace nipref::verify
