#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include <nipref/verify/solve/internal/collect_results.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

/// Calls solve(), which finds out whether the speed is subcritical.
auto refusing_speed(const data::Scene& scene, const data::HalfSpaceProblem& problem, const auto& solve) {
  try {
    return solve();
  } catch (const data::BadInput& error) {
    if (error.argument() != "speed") throw;
    const bool rolls = std::holds_alternative<data::RigidRollingSphere>(problem.body);
    scene.origin.refuse_as(rolls ? "rolling.speed" : "sliding.speed", error);
  }
}

SolvedInDouble solved(const data::Scene& scene, const data::HalfSpaceProblem& problem) {
  return refusing_speed(scene, problem, [&] { return solve_half_space(problem); });
}
SolvedInDouble solved(const data::Scene& scene, const auto& nip) {
  return naming_given(scene, nip.given, [&] { return solve_nip(nip, scene.accuracy); });
}

void refuse_moments(const data::Scene& scene) {
  for (std::size_t i = 0; i < scene.wanted.size(); ++i) {
    if (is_moment(scene.wanted[i])) {
      scene.origin.refuse(
          fmt::format("wanted[{}]", i), data::scene_result(scene.wanted[i]).name,
          "must be wanted of the fast path: the reference has the eccentricity, their sum over the load, "
          "and moments of rolling line loads");
    }
  }
}

SolvedByRef solved_by_ref(const data::Scene& scene, const data::HalfSpaceProblem& problem, int digits) {
  return refusing_speed(scene, problem, [&] {
    const ref::JointResponse surface(problem, digits);
    surface.check_subcritical();
    return solve_ref_half_space(surface, problem, digits);
  });
}
SolvedByRef solved_by_ref(const data::Scene& scene, const auto& nip, int digits) {
  const bool is_rolling = std::holds_alternative<data::ViscoelasticNipProblem>(scene.system);
  if (!is_rolling || !is_by_line_loads(scene)) refuse_moments(scene);
  return naming_given(scene, nip.given, [&] { return solve_ref_nip(nip, digits); });
}

/// The largest ratio of an error of the result to its allowed error.
long double excess(const SceneSolution<fast::Estimate>::Result& result) {
  long double largest = 0;
  for (std::size_t i = 0; i < result.numbers.size(); ++i)
    largest = std::max(largest, result.numbers[i].error / result.allowed[i]);
  return largest;
}

/// More terms may increase rounding errors, so that a result is replaced only by a better one.
void collect_better(const data::Scene& scene, const SolvedContact<fast::Estimate>& contact,
                    SceneSolution<fast::Estimate>& solution) {
  for (std::size_t wanted = 0; wanted < solution.results.size(); ++wanted) {
    auto& result = solution.results[wanted];
    if (result.met().value_or(true)) continue;
    auto refined = collect_result(scene, wanted, contact, solution);
    if (excess(refined) < excess(result)) result = std::move(refined);
  }
  solution.work = contact.work();
}

/// The solution, with the time that it takes.
template <class Number>
SceneSolution<Number> timed(const auto& solution_of) {
  SceneSolution<Number> solution;
  const double seconds = seconds_of([&] { solution = solution_of(); });
  solution.seconds = seconds;
  return solution;
}

}  // namespace

SceneSolution<fast::Estimate> solve(const data::Scene& scene) {
  scene.check();
  return timed<fast::Estimate>([&] {
    const SolvedInDouble contact =
        std::visit([&](const auto& problem) { return solved(scene, problem); }, scene.system);
    auto solution = collect_results(scene, *contact, scene.accuracy);
    while (!solution.missed().empty() && contact->refine()) collect_better(scene, *contact, solution);
    return solution;
  });
}

SceneSolution<ref::Estimate> solve_by_ref(const data::Scene& scene, int digits) {
  scene.check();
  return timed<ref::Estimate>([&] {
    const SolvedByRef contact =
        std::visit([&](const auto& problem) { return solved_by_ref(scene, problem, digits); }, scene.system);
    return collect_results(scene, *contact, std::pow(10.0L, -digits));
  });
}

}  // namespace nipref::verify
