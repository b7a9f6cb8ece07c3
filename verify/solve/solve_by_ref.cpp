#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include <nipref/verify/solve/internal/collect_results.hpp>
#include <nipref/verify/solve/internal/derived_results.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/solve/internal/refuse_given.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

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

SolvedByRef solved(const data::ElasticNipProblem& problem, int digits) {
  const auto* const loads = std::get_if<data::LineLoads>(&problem.method);
  return loads != nullptr ? solve_ref_line_loads(problem, *loads, digits)
                          : solve_ref_converged(problem, digits);
}
SolvedByRef solved(const data::ViscoelasticNipProblem& problem, int digits) {
  const auto* const loads = std::get_if<data::ViscoelasticLineLoads>(&problem.method);
  return loads != nullptr ? solve_ref_line_loads(problem, *loads, digits)
                          : solve_ref_converged(problem, digits);
}

SceneSolution<ref::Estimate> solution_of(const data::Scene& scene, const data::HalfSpaceProblem& problem,
                                         int digits) {
  const RefSurface surface(problem, digits);
  surface.check_subcritical(scene.origin);
  return collect_results(scene, problem.profile, *solve_ref_half_space(surface, problem, digits),
                         std::pow(10.0L, -digits));
}
SceneSolution<ref::Estimate> solution_of(const data::Scene& scene, const auto& nip, int digits) {
  const bool is_rolling = std::holds_alternative<data::ViscoelasticNipProblem>(scene.system);
  if (!is_rolling || !is_by_line_loads(scene)) refuse_moments(scene);
  const SolvedByRef contact = [&] {
    try {
      return solved(nip, digits);
    } catch (const data::BadInput& error) {
      refuse_given(scene, nip.given, error);
    }
  }();
  return collect_results(scene, nip.profile, WithDerivedResults(scene, *contact), std::pow(10.0L, -digits));
}

}  // namespace

SceneSolution<ref::Estimate> solve_by_ref(const data::Scene& scene, int digits) {
  scene.check();
  SceneSolution<ref::Estimate> solution;
  const double seconds = seconds_of([&] {
    solution =
        std::visit([&](const auto& problem) { return solution_of(scene, problem, digits); }, scene.system);
  });
  solution.seconds = seconds;
  return solution;
}

}  // namespace nipref::verify
