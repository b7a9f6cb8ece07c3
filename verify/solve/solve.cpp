#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>

#include <nipref/verify/solve/internal/collect_results.hpp>
#include <nipref/verify/solve/internal/derived_results.hpp>
#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/solve/internal/refuse_given.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

SolvedInDouble solved(const data::ElasticNipProblem& problem, double accuracy) {
  const auto* const loads = std::get_if<data::LineLoads>(&problem.method);
  return loads != nullptr ? solve_line_loads(problem, *loads, accuracy) : solve_converged(problem, accuracy);
}
SolvedInDouble solved(const data::ViscoelasticNipProblem& problem, double accuracy) {
  const auto* const loads = std::get_if<data::ViscoelasticLineLoads>(&problem.method);
  return loads != nullptr ? solve_line_loads(problem, *loads) : solve_converged(problem, accuracy);
}

SolvedInDouble solved(const data::Scene& scene, const data::HalfSpaceProblem& problem) {
  return solve_half_space(scene, problem);
}
SolvedInDouble solved(const data::Scene& scene, const auto& nip) {
  try {
    return solved(nip, scene.accuracy);
  } catch (const data::BadInput& error) {
    refuse_given(scene, nip.given, error);
  }
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

}  // namespace

SceneSolution<fast::Estimate> solve(const data::Scene& scene) {
  scene.check();
  SceneSolution<fast::Estimate> solution;
  const auto solve_system = [&](const auto& problem) {
    const SolvedInDouble contact = solved(scene, problem);
    const WithDerivedResults results(scene, *contact);
    solution = collect_results(scene, problem.profile, results, scene.accuracy);
    while (!solution.missed().empty() && contact->refine()) collect_better(scene, results, solution);
  };
  const double seconds = seconds_of([&] { std::visit(solve_system, scene.system); });
  solution.seconds = seconds;
  return solution;
}

}  // namespace nipref::verify
