#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

SolvedInDouble solved(const data::HalfSpaceProblem& problem, double) { return solve_half_space(problem); }
SolvedInDouble solved(const auto& nip, double accuracy) { return solve_nip(nip, accuracy); }

SolvedByRef solved_by_ref(const data::HalfSpaceProblem& problem, int digits) {
  const ref::JointResponse surface(problem, digits);
  surface.check_subcritical();
  return solve_ref_half_space(surface, problem, digits);
}
SolvedByRef solved_by_ref(const auto& nip, int digits) { return solve_ref_nip(nip, digits); }

void refuse_moments_by_ref(const data::Scene& scene) {
  if (std::holds_alternative<data::ViscoelasticNipProblem>(scene.system) && is_by_line_loads(scene)) return;
  for (std::size_t i = 0; i < scene.wanted.size(); ++i) {
    if (is_moment(scene.wanted[i])) {
      scene.origin.refuse(
          fmt::format("wanted[{}]", i), data::scene_result(scene.wanted[i]).name,
          "must be wanted of the fast path: the reference has the eccentricity, their sum over the load, "
          "and moments of rolling line loads");
    }
  }
}

}  // namespace

SceneSolution<fast::Estimate> solve(const data::Scene& scene) {
  scene.check();
  auto [solution, seconds] = timed([&] {
    const SolvedInDouble contact = naming_keys(scene, [&] {
      return std::visit([&](const auto& problem) { return solved(problem, scene.accuracy); }, scene.system);
    });
    auto found = collect_results(scene, *contact, scene.accuracy);
    while (!found.missed().empty() && contact->refine()) collect_better(scene, *contact, found);
    return found;
  });
  solution.seconds = seconds;
  return solution;
}

SceneSolution<ref::Estimate> solve_by_ref(const data::Scene& scene, int digits) {
  scene.check();
  refuse_moments_by_ref(scene);
  auto [solution, seconds] = timed([&] {
    const SolvedByRef contact = naming_keys(scene, [&] {
      return std::visit([&](const auto& problem) { return solved_by_ref(problem, digits); }, scene.system);
    });
    return collect_results(scene, *contact, std::pow(10.0L, -digits));
  });
  solution.seconds = seconds;
  return solution;
}

}  // namespace nipref::verify
