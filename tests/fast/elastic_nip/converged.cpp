// The converged contact: its own equations, two discretisations.
#include <nipref/fast/elastic_nip/internal/elastic_equations.hpp>
#include <nipref/fast/nip/internal/solved_nip.hpp>

#include "support/test.hpp"

using namespace nipref;
using data::Friction;

TEST_CASE("one expansion over the whole contact and panels that double from its end agree") {
  for (const double half_length : {0.05, 0.7, 2.5}) {
    for (const Friction friction : {Friction::none, Friction::full}) {
      CAPTURE(half_length);
      const fast::ElasticEquations equations(friction, 0.3);
      fast::Work work;
      fast::CountedKernels kernels(fast::Accuracy{}, work);
      const double a = half_length;
      const fast::Solution one = equations.solve(a, {{0, 2 * a, true, true, 24}}, 1e-16, kernels);
      const fast::Solution other = equations.solve(
          a,
          {{0, a / 4, true, false, 24}, {a / 4, a / 2, false, false, 24}, {a / 2, 1.5 * a, false, true, 16}},
          1e-16, kernels);
      CHECK(one.value(one.load()) == approx(other.value(other.load()), 1e-12));
      const double peak = one.traction(a).real();
      for (const double x : {1e-4, 0.1, 0.4, 0.6, 1.0})
        CHECK(std::abs(one.traction(x * a) - other.traction(x * a)) < 1e-10 * peak);
    }
  }
}

TEST_CASE("between its matching points a solution satisfies its equations") {
  for (const double half_length : {0.01, 1.0, 6.0, 40.0}) {
    for (const double poisson : {-0.5, 1.0 / 3, 0.5}) {
      for (const Friction friction : {Friction::none, Friction::full}) {
        CAPTURE(half_length, poisson);
        const auto equations = std::make_shared<const fast::ElasticEquations>(friction, poisson);
        const fast::SolvedNip nip(equations, half_length, {}, 1e-12);
        const fast::Solution& solution = nip.last();
        fast::CountedKernels kernels = nip.kernels();
        const double edge = solution.unknown(fast::ElasticEquations::edge_displacement);
        const double depth = edge + half_length * half_length, peak = solution.traction(half_length).real();
        for (const double x : {1e-3, 0.0371, 0.217, 0.63, 0.971}) {
          const double e = x * half_length;
          CHECK(std::fabs(solution.value(equations->normal_displacement(solution, {false, e}, kernels)) -
                          (edge + e * (2 * half_length - e))) < 1e-11 * (depth + peak));
          if (friction == Friction::full) {
            const double creep = solution.unknown(fast::ElasticEquations::creep);
            CHECK(std::fabs(
                      solution.value(equations->along_surface(solution, {false, e}, kernels).displacement) -
                      creep * (half_length - e)) < 1e-11 * (depth + peak * half_length));
          }
        }
      }
    }
  }
}

TEST_CASE("with full friction the length for a load is found with few systems, however stiff the film is") {
  for (const double poisson : {0.0, 0.45, 0.4999, 0.4999999}) {
    const auto equations = std::make_shared<const fast::ElasticEquations>(Friction::full, poisson);
    for (const double half_length : {0.1, 3.0, 30.0, 300.0, 2000.0}) {
      CAPTURE(poisson, half_length);
      const fast::SolvedNip given(equations, half_length, {}, 1e-8);
      const double load = given.last().carried_load(), guess = equations->half_length_of(load);
      CHECK(std::fabs(std::log(guess / half_length)) < 0.5);
      const fast::SolvedNip found(equations, guess, load, 1e-8);
      CHECK(found.work().systems <= 5);
      CHECK(std::fabs(found.half_length() - half_length) <= 1e-6 * half_length);
    }
  }
}
