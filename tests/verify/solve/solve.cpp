#include <nipref/data/scene/file.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/refusal.hpp"
#include "support/solved_scene.hpp"
#include "support/test.hpp"
#include "support/thesis_nips.hpp"

using namespace nipref;
using fast::Estimate;
using test::quarter_inch_nip;

namespace {

const data::Positions inside_and_outside{{-0.2, -0.03, 0.0, 0.01, 0.05, 0.2}};

data::Scene scene_of(data::Friction friction, const std::vector<data::ResultId>& wanted,
                     double accuracy = 1e-8) {
  data::ElasticNipProblem problem{.nip = quarter_inch_nip,
                                  .given = data::GivenLoad{100},
                                  .friction = friction,
                                  .creep_ratio = {},
                                  .method = data::ConvergedMethod{},
                                  .profile = inside_and_outside};
  return {.title = "test", .wanted = wanted, .accuracy = accuracy, .system = problem, .origin = {}};
}

/// Values of the kernels that shear or tangential displacement need.
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

void check_same(const Estimate& found, const Estimate& expected) {
  CHECK(found.value == expected.value);
  CHECK(found.error == expected.error);
}

const data::Friction frictions[] = {data::Friction::none, data::Friction::full};

}  // namespace

TEST_CASE("each name of a scene is the solver's result of that name") {
  // Where the solver stops nothing is missed, so that no result is refined.
  constexpr double accuracy = 1e-10;
  for (const data::Friction friction : frictions) {
    const auto solution = verify::solve(scene_of(friction, all_results(), accuracy));
    const auto contact = fast::converged_for_load(quarter_inch_nip, friction, 100, accuracy);
    check_same(solution[data::ResultId::contact_length], contact.contact_length());
    check_same(solution[data::ResultId::load], contact.load());
    check_same(solution[data::ResultId::indentation], contact.indentation());
    check_same(solution[data::ResultId::edge_displacement], contact.leading_displacement());
    check_same(solution[data::ResultId::creep_ratio], contact.creep_ratio());
    check_same(solution[data::ResultId::peak_pressure], contact.peak_pressure());
    check_same(solution[data::ResultId::peak_shear], contact.peak_shear());
    CHECK(solution.positions == inside_and_outside.y);
    for (std::size_t i = 0; i < solution.positions.size(); ++i) {
      const double y = solution.positions[i];
      check_same(solution.profile(data::ResultId::pressure)[i], contact.pressure(y));
      check_same(solution.profile(data::ResultId::shear)[i], contact.shear(y));
      check_same(solution.profile(data::ResultId::normal_displacement)[i], contact.normal_displacement(y));
      check_same(solution.profile(data::ResultId::tangential_displacement)[i],
                 contact.tangential_displacement(y));
    }
  }
}

TEST_CASE("a scene with a given length and the scene with the load that follows are the same contact") {
  data::Scene by_length =
      scene_of(data::Friction::full,
               {data::ResultId::load, data::ResultId::indentation, data::ResultId::creep_ratio}, 1e-10);
  problem_of(by_length).given = data::GivenLength{0.3};
  const auto first = verify::solve(by_length);
  data::Scene by_load = scene_of(
      data::Friction::full,
      {data::ResultId::contact_length, data::ResultId::indentation, data::ResultId::creep_ratio}, 1e-10);
  problem_of(by_load).given = data::GivenLoad{first[data::ResultId::load].value};
  const auto second = verify::solve(by_load);
  CHECK(second[data::ResultId::contact_length].value == doctest::Approx(0.3).epsilon(1e-9));
  CHECK(second[data::ResultId::indentation].value ==
        doctest::Approx(first[data::ResultId::indentation].value).epsilon(1e-9));
  CHECK(second[data::ResultId::creep_ratio].value ==
        doctest::Approx(first[data::ResultId::creep_ratio].value).epsilon(1e-8));
}

TEST_CASE("evenly spaced positions go from the middle of the nip to the end of the contact") {
  data::Scene scene =
      scene_of(data::Friction::none, {data::ResultId::contact_length, data::ResultId::normal_displacement,
                                      data::ResultId::indentation, data::ResultId::edge_displacement});
  problem_of(scene).profile = data::EvenlySpaced{5};
  const auto solution = verify::solve(scene);
  const double half = solution[data::ResultId::contact_length].value / 2;
  REQUIRE(solution.positions.size() == 5);
  for (std::size_t i = 0; i < 5; ++i)
    CHECK(solution.positions[i] == doctest::Approx(half * static_cast<double>(i) / 4));
  const auto& u = solution.profile(data::ResultId::normal_displacement);
  CHECK(u.front().value == doctest::Approx(solution[data::ResultId::indentation].value).epsilon(1e-8));
  CHECK(u.back().value == doctest::Approx(solution[data::ResultId::edge_displacement].value).epsilon(1e-8));
}

TEST_CASE("positions without a wanted profile cost nothing and are not reported") {
  data::Scene scene = scene_of(data::Friction::none, {data::ResultId::load});
  const auto with = verify::solve(scene);
  problem_of(scene).profile.reset();
  const auto without = verify::solve(scene);
  CHECK(with.positions.empty());
  CHECK(with.work.kernel_evaluations == without.work.kernel_evaluations);
}

TEST_CASE("a result that the scene does not want is refused by name") {
  const auto solution = verify::solve(scene_of(data::Friction::none, {data::ResultId::load}));
  CHECK_THROWS_WITH_AS((void)solution[data::ResultId::creep_ratio],
                       "result = creep_ratio: must be among what the scene wants", data::BadInput);
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

TEST_CASE("a coarser accuracy costs fewer unknowns and fewer series terms") {
  for (const data::Friction friction : frictions) {
    const std::vector<data::ResultId> wanted{data::ResultId::contact_length, data::ResultId::creep_ratio};
    const auto coarse = verify::solve(scene_of(friction, wanted, 1e-4)).work;
    const auto fine = verify::solve(scene_of(friction, wanted, 1e-13)).work;
    CHECK(coarse.unknowns < fine.unknowns);
    CHECK(coarse.terms < fine.terms);
    CHECK(costs_no_more(coarse, fine));
  }
}

TEST_CASE("wanting less never costs more") {
  for (const data::Friction friction : frictions) {
    std::vector<data::ResultId> wanted = all_results();
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

TEST_CASE("a contact that is not allowed shows on solving, and is refused by what was given") {
  data::Scene scene = scene_of(data::Friction::none, {data::ResultId::load});
  const auto refusal = [&](const auto& given) {
    problem_of(scene).given = given;
    return refusal_of([&] { return verify::solve(scene); });
  };
  for (const double load : {1e-200, 1e10, 1e300})
    CHECK(refusal(data::GivenLoad{load}).starts_with("load.per_length = "));
  CHECK(refusal(data::GivenLength{1e-10}).starts_with("contact.length = 1e-10: "));
}
