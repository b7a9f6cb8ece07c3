#include <nipref/fast/elastic_nip/converged.hpp>

#include "support/solved_scene.hpp"
#include "support/thesis_nips.hpp"

using namespace nipref;
using fast::Estimate;
using test::quarter_inch_nip;

namespace {

data::Scene scene_of(data::Friction friction, const std::vector<data::ResultId>& wanted,
                     double accuracy = 1e-8) {
  return scene_wanting(quarter_inch_problem(friction), wanted, accuracy);
}

/// The number of values of kernels that only shear or tangential displacements need.
std::uint64_t other_kernels(const fast::Work& work) {
  return std::accumulate(work.kernel_evaluations.begin() + 1, work.kernel_evaluations.end(),
                         std::uint64_t{0});
}

bool costs_no_more(const fast::Work& less, const fast::Work& more) {
  bool holds = less.terms <= more.terms && less.unknowns <= more.unknowns && less.systems <= more.systems;
  for (std::size_t k = 0; k < less.kernel_evaluations.size(); ++k)
    holds = holds && less.kernel_evaluations[k] <= more.kernel_evaluations[k];
  return holds;
}

const data::Friction frictions[] = {data::Friction::none, data::Friction::full};

}  // namespace

TEST_CASE("each name of a scene is the solver's result of that name") {
  // The solver itself misses nothing at this accuracy, so that no result is refined.
  constexpr double accuracy = 1e-10;
  for (const data::Friction friction : frictions) {
    const auto solution = verify::solve(scene_of(friction, all_results(), accuracy));
    const auto contact = fast::converged_for_load(quarter_inch_nip, friction, 100, accuracy);
    CHECK(solution.positions == std::get<data::Positions>(*quarter_inch_problem(friction).profile).y);
    check_names(solution, contact, [](const Estimate& found, const Estimate& expected) {
      CHECK(found.value == expected.value);
      CHECK(found.error == expected.error);
    });
  }
}

TEST_CASE("even positions go from the middle, of a rolling contact the trailing end, to the leading end") {
  using enum data::ResultId;
  data::Scene scene = scene_of(data::Friction::none, {normal_displacement, indentation, edge_displacement});
  problem_of(scene).profile = data::EvenlySpaced{5};
  const auto solution = verify::solve(scene);
  REQUIRE(solution.positions.size() == 5);
  CHECK(solution.positions[2] == approx(solution.positions[4] / 2, 1e-15));
  const auto& u = solution.profile(normal_displacement);
  CHECK(u.front().value == approx(solution[indentation].value, 1e-8));
  CHECK(u.back().value == approx(solution[edge_displacement].value, 1e-8));
  const auto rolling = verify::solve(loaded_example(
      "viscoelastic-short-memory", {{"material.relaxation_time", "0.1"},
                                    {"wanted", R"(["pressure", "leading_length", "trailing_length"])"},
                                    {"profile.points", "5"}}));
  REQUIRE(rolling.positions.size() == 5);
  CHECK(rolling.positions.front() == -rolling[trailing_length].value);
  CHECK(rolling.positions.back() == rolling[leading_length].value);
  const auto& p = rolling.profile(data::ResultId::pressure);
  CHECK(p.front().value == 0);
  CHECK(p.back().value == 0);
  // The sheet is stiffest where it has been pressed for the shortest time.
  CHECK(p[3].value > 1.1 * p[1].value);
}

TEST_CASE("what a scene does not want costs nothing, is not reported, and is refused by name") {
  data::Scene scene = scene_of(data::Friction::none, {data::ResultId::load});
  const auto with = verify::solve(scene);
  problem_of(scene).profile.reset();
  CHECK(with.positions.empty());
  CHECK(with.work.kernel_evaluations == verify::solve(scene).work.kernel_evaluations);
  CHECK_REFUSED(with[data::ResultId::creep_ratio],
                "result = creep_ratio: must be among what the scene wants");
}

TEST_CASE("a frictionless scene that wants no tangential result evaluates I1 alone") {
  using enum data::ResultId;
  const std::vector normal{contact_length, load,  indentation, edge_displacement,  peak_pressure,
                           pressure,       shear, peak_shear,  normal_displacement};
  const auto solution = verify::solve(scene_of(data::Friction::none, normal));
  CHECK(solution.work.kernel_evaluations[0] > 0);
  CHECK(other_kernels(solution.work) == 0);
  for (const data::ResultId tangential :
       {data::ResultId::creep_ratio, data::ResultId::tangential_displacement}) {
    CHECK(other_kernels(verify::solve(scene_of(data::Friction::none, {tangential})).work) > 0);
  }
}

TEST_CASE("less accuracy and less that is wanted never cost more") {
  for (const data::Friction friction : frictions) {
    std::vector<data::ResultId> wanted{data::ResultId::contact_length, data::ResultId::creep_ratio};
    const auto coarse = verify::solve(scene_of(friction, wanted, 1e-4)).work;
    const auto fine = verify::solve(scene_of(friction, wanted, 1e-13)).work;
    CHECK(coarse.unknowns < fine.unknowns);
    CHECK(coarse.terms < fine.terms);
    CHECK(costs_no_more(coarse, fine));
    wanted = all_results();
    auto more = verify::solve(scene_of(friction, wanted)).work;
    while (wanted.size() > 1) {
      CAPTURE(wanted.back());
      wanted.pop_back();
      const auto less = verify::solve(scene_of(friction, wanted)).work;
      CHECK(costs_no_more(less, more));
      more = less;
    }
  }
}
