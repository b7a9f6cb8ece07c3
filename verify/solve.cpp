#include "verify/solve.hpp"

#include <variant>

#include "verify/collect_results.hpp"
#include "verify/refuse_given.hpp"
#include "verify/solve_methods.hpp"
#include "verify/stopwatch.hpp"

namespace nipref::verify {
namespace {

using Solved = std::unique_ptr<SolvedContact<fast::Estimate>>;

struct SolveRollingByMethod {
  const data::ViscoelasticNipProblem& problem;
  double accuracy;

  Solved operator()(const data::ConvergedMethod&) const { return solve_rolling(problem, accuracy); }
  Solved operator()(const data::RollingLineLoads& loads) const {
    return solve_rolling_line_loads(problem, loads);
  }
};

struct SolveByMethod {
  const data::ElasticNipProblem& problem;
  double accuracy;

  Solved operator()(const data::ConvergedMethod&) const { return solve_converged(problem, accuracy); }
  Solved operator()(const data::LineLoads& loads) const { return solve_line_loads(problem, loads, accuracy); }
};

struct SolveSystem {
  double accuracy;

  Solved operator()(const data::ElasticNipProblem& problem) const {
    return std::visit(SolveByMethod{problem, accuracy}, problem.method);
  }
  Solved operator()(const data::ViscoelasticNipProblem& problem) const {
    return std::visit(SolveRollingByMethod{problem, accuracy}, problem.method);
  }
};

Solved solve_named(const data::Scene& scene, const data::Given& given) {
  try {
    return std::visit(SolveSystem{scene.accuracy}, scene.system);
  } catch (const data::BadInput& error) {
    refuse_given(scene, given, error);
  }
}

}  // namespace

SceneSolution<fast::Estimate> solve(const data::Scene& scene) {
  scene.check();
  SceneSolution<fast::Estimate> solution;
  const auto solve_system = [&](const auto& problem) {
    solution = collect_results(scene, problem.profile, *solve_named(scene, problem.given));
  };
  const double seconds = seconds_of([&] { std::visit(solve_system, scene.system); });
  solution.seconds = seconds;
  return solution;
}

}  // namespace nipref::verify
