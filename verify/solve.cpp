#include "verify/solve.hpp"

#include <variant>

#include "verify/collect_results.hpp"
#include "verify/refuse_given.hpp"
#include "verify/solve_methods.hpp"
#include "verify/stopwatch.hpp"

namespace nipref::verify {
namespace {

using Solved = std::unique_ptr<SolvedContact<fast::Estimate>>;

struct SolveByMethod {
  const data::ElasticNipProblem& problem;
  double accuracy;

  Solved operator()(const data::ConvergedMethod&) const { return solve_converged(problem, accuracy); }
  Solved operator()(const data::LineLoads& loads) const { return solve_line_loads(problem, loads, accuracy); }
};

Solved solve_named(const data::Scene& scene, const data::ElasticNipProblem& problem) {
  try {
    return std::visit(SolveByMethod{problem, scene.accuracy}, problem.method);
  } catch (const data::BadInput& error) {
    refuse_given(scene, problem, error);
  }
}

}  // namespace

SceneSolution<fast::Estimate> solve(const data::Scene& scene) {
  scene.check();
  SceneSolution<fast::Estimate> solution;
  const auto solve_system = [&](const data::ElasticNipProblem& problem) {
    solution = collect_results(scene, problem, *solve_named(scene, problem));
  };
  const double seconds = seconds_of([&] { std::visit(solve_system, scene.system); });
  solution.seconds = seconds;
  return solution;
}

}  // namespace nipref::verify
