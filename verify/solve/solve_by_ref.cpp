#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include <nipref/verify/solve/internal/collect_results.hpp>
#include <nipref/verify/solve/internal/derived_results.hpp>
#include <nipref/verify/solve/internal/ref_methods.hpp>
#include <nipref/verify/solve/internal/refuse_given.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

using SolvedByRef = std::unique_ptr<SolvedContact<ref::Estimate>>;

struct SolveRefByMethod {
  const data::ElasticNipProblem& problem;
  int digits;

  SolvedByRef operator()(const data::ConvergedMethod&) const { return solve_ref_converged(problem, digits); }
  SolvedByRef operator()(const data::LineLoads& loads) const {
    return solve_ref_line_loads(problem, loads, digits);
  }
};

SolvedByRef solve_named(const data::Scene& scene, const data::ElasticNipProblem& problem, int digits) {
  try {
    return std::visit(SolveRefByMethod{problem, digits}, problem.method);
  } catch (const data::BadInput& error) {
    if (error.argument() == "digits") throw;
    refuse_given(scene, problem.given, error);
  }
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

SceneSolution<ref::Estimate> solve_elastic(const data::Scene& scene, const data::ElasticNipProblem& problem,
                                           int digits) {
  refuse_moments(scene);
  const SolvedByRef contact = solve_named(scene, problem, digits);
  return collect_results(scene, problem.profile, WithDerivedResults(scene, *contact),
                         std::pow(10.0L, -digits));
}

SceneSolution<ref::Estimate> solve_rolling(const data::Scene& scene,
                                           const data::ViscoelasticNipProblem& problem, int digits) {
  const auto* loads = std::get_if<data::ViscoelasticLineLoads>(&problem.method);
  if (loads == nullptr) refuse_moments(scene);
  const SolvedByRef solved = [&] {
    try {
      return loads != nullptr ? solve_ref_rolling_line_loads(problem, *loads, digits)
                              : solve_ref_rolling(problem, digits);
    } catch (const data::BadInput& error) {
      if (loads != nullptr && error.argument().ends_with(" rate")) scene.origin.refuse_as("material", error);
      refuse_rolling(scene, problem, error);
    }
  }();
  return collect_results(scene, problem.profile, WithDerivedResults(scene, *solved),
                         std::pow(10.0L, -digits));
}

struct SolveSystemByRef {
  const data::Scene& scene;
  int digits;

  SceneSolution<ref::Estimate> operator()(const data::ElasticNipProblem& problem) const {
    return solve_elastic(scene, problem, digits);
  }
  SceneSolution<ref::Estimate> operator()(const data::ViscoelasticNipProblem& problem) const {
    return solve_rolling(scene, problem, digits);
  }
  SceneSolution<ref::Estimate> operator()(const data::HalfSpaceProblem& problem) const {
    const RefSurface surface(problem);
    surface.check_subcritical(scene.origin);
    return collect_results(scene, problem.profile, *solve_ref_half_space(surface, problem, digits),
                           std::pow(10.0L, -digits));
  }
};

}  // namespace

SceneSolution<ref::Estimate> solve_by_ref(const data::Scene& scene, int digits) {
  scene.check();
  SceneSolution<ref::Estimate> solution;
  const double seconds = seconds_of([&] {
    solution = std::visit(SolveSystemByRef{scene, digits}, scene.system);
  });
  solution.seconds = seconds;
  return solution;
}

}  // namespace nipref::verify
