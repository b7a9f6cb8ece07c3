#include <doctest/doctest.h>

#include <cmath>

#include <nipref/data/scene/file.hpp>
#include <nipref/verify/audit/internal/half_space_truth.hpp>
#include <nipref/verify/solve/solve.hpp>

using namespace nipref;

namespace {

/// Everything that the reference has of the example is what solve finds, to 1e-12; gives how many numbers.
int check_example(const char* name, bool dear, const data::SceneOverrides& overrides = {}) {
  CAPTURE(name);
  data::Scene scene = data::load_scene(data::example_scene(name), overrides);
  auto& problem = std::get<data::HalfSpaceProblem>(scene.system);
  if (!problem.profile) problem.profile = data::Positions{{-60, 0, 20, 90}};
  for (const char* profile : {"span", "compliance", "coupling"}) {
    if (std::ranges::find(scene.wanted, profile) == scene.wanted.end()) scene.wanted.emplace_back(profile);
  }
  const verify::HalfSpaceTruth truth(problem, dear);
  const auto solved = verify::solve(scene);
  int known = 0;
  for (const auto& result : solved.results) {
    CAPTURE(result.what->name);
    for (std::size_t i = 0; i < result.numbers.size(); ++i) {
      const double degrees = result.what->is_profile ? solved.positions[i] : 0;
      CAPTURE(degrees);
      const auto number = truth.of(result.what->name, degrees);
      if (!number) continue;
      ++known;
      const double size =
          result.what->name == "coupling" ? solved.profile("compliance")[i].value : result.numbers[i].value;
      CHECK(std::fabs(static_cast<double>(number->value - result.numbers[i].value)) <= 1e-12 * size);
      CHECK(number->error <= 1e-15 * size);
    }
  }
  return known;
}

}  // namespace

TEST_CASE(
    "the reference's half-spaces are the scenes' own: lines, critical speeds, spans by the papers' rule") {
  // Lines, and what of the rule does not need the force.
  CHECK(check_example("half-space-rolling-sphere", false) == 4 + 3 * 4);
  CHECK(check_example("half-space-sliding-die", false) >= 1 + 2 * 4);
  CHECK(check_example("half-space-sphere-normal-axis", false) >= 1 + 2 * 4);
  CHECK(check_example("half-space-sphere-in-plane-axis", false) == 2 * 9);
}

TEST_CASE(
    "where it may take longer the reference has exact ellipses, and critical speeds of anisotropic solids") {
  CHECK(check_example("half-space-near-critical", true, {{"sliding.speed", "1500"}}) == 1 + 2 * 4 + 2);
  CHECK(check_example("half-space-sphere-normal-axis", true) ==
        check_example("half-space-sphere-normal-axis", false) + 1);
}
