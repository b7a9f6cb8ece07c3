#include <nlohmann/json.hpp>

#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/data/scene/file.hpp>
#include <nipref/data/scene/scene.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/refusal.hpp"
#include "support/solved_scene.hpp"
#include "support/test.hpp"

using namespace nipref;

namespace {

data::Scene scene_of(double thickness, const std::vector<data::ResultId>& wanted) {
  data::ElasticNipProblem problem{.nip = data::seed::nip(thickness),
                                  .given = data::GivenLoad{100},
                                  .creep_ratio = {},
                                  .method = data::ConvergedMethod{},
                                  .profile = data::Positions{{-0.02, 0.0, 0.01, 0.5}}};
  return {.title = "test", .wanted = wanted, .accuracy = 1e-11, .system = problem, .origin = {}};
}

data::Scene line_load_scene() {
  data::Scene scene =
      scene_of(0.25, {data::ResultId::load, data::ResultId::indentation, data::ResultId::edge_displacement});
  problem_of(scene).given = data::GivenLength{0.15};
  problem_of(scene).method = data::LineLoads{5, 5};
  return scene;
}

void check_unsolvable(const data::Scene& scene, const std::string& start, int digits = 16) {
  CAPTURE(start);
  CHECK(refusal_of([&] { return verify::solve_by_ref(scene, digits); }).starts_with(start));
}

}  // namespace

TEST_CASE("the reference counts its work, of the kernels that it needs") {
  for (const data::Friction friction : {data::Friction::none, data::Friction::full}) {
    data::Scene scene = scene_of(0.25, {data::ResultId::load, data::ResultId::tangential_displacement});
    problem_of(scene).friction = friction;
    const fast::Work work = verify::solve_by_ref(scene, 20).work;
    for (const std::size_t kernel : {0U, 2U}) CHECK(work.kernel_evaluations[kernel] > 0);
    CHECK((work.kernel_evaluations[5] > 0) == (friction == data::Friction::full));
    CHECK(work.unknowns > 0);
  }
}

TEST_CASE("without memory the reference knows that the resistance is 0, to the digits asked for") {
  const auto solution =
      verify::solve_by_ref(data::load_scene(data::example_scene("viscoelastic-elastic-limit")), 16);
  CHECK(solution.missed().empty());
}

namespace {

template <class Solution>
nlohmann::ordered_json json_of(const Solution& solution) {
  return nlohmann::ordered_json::parse(verify::solution_json(solution).text());
}

}  // namespace

TEST_CASE("what the reference solves is proven, what fast solves is estimated, and both say so") {
  const auto loads = verify::solve_by_ref(line_load_scene(), 20);
  const auto json = json_of(loads);
  CHECK(json.at("results").size() == 3);
  for (const auto& result : json.at("results")) CHECK(result.at("proven") == true);
  CHECK(json.at("results").at("load").at("error") == loads[data::ResultId::load].error_text());
  CHECK(contains(verify::text_of("solve.txt", verify::solution_json(loads)), " bound "));
  CHECK(!contains(verify::text_of("solve.txt", verify::solution_json(loads)), " error "));

  const data::Scene scene =
      scene_of(0.25, {data::ResultId::load, data::ResultId::pressure, data::ResultId::shear});
  const auto contact = json_of(verify::solve_by_ref(scene, 20));
  CHECK(contact.at("results").size() == 3);
  for (const auto& result : contact.at("results")) CHECK(result.at("proven") == true);
  CHECK(contact.at("results").at("pressure").at("error").size() == 4);

  data::Scene gripped = scene;
  problem_of(gripped).friction = data::Friction::full;
  gripped.wanted = {data::ResultId::peak_pressure, data::ResultId::peak_shear};
  const auto with_friction = json_of(verify::solve_by_ref(gripped, 20));
  for (const auto& result : with_friction.at("results")) CHECK(result.at("proven") == false);

  const auto estimated = verify::solve(scene);
  const auto in_double = json_of(estimated);
  for (const auto& result : in_double.at("results")) CHECK(result.at("proven") == false);
  CHECK(!contains(verify::text_of("solve.txt", verify::solution_json(estimated)), " bound "));
}

TEST_CASE("the reference's line loads carry a given load, all of their results as in double") {
  data::Scene scene = line_load_scene();
  scene.wanted = all_results();
  for (const auto id : {data::ResultId::leading_moment, data::ResultId::trailing_moment})
    std::erase(scene.wanted, id);
  problem_of(scene).given = data::GivenLoad{100};
  problem_of(scene).method = data::LineLoads{3, 3, 100};
  for (const bool friction : {false, true}) {
    if (friction) problem_of(scene).friction = data::Friction::full;  // with the thesis's creep
    const auto fast = verify::solve(scene);
    const auto reference = verify::solve_by_ref(scene, 18);
    CHECK(reference.work.unknowns == (friction ? 7 : 4));
    for (std::size_t r = 0; r < scene.wanted.size(); ++r) {
      CAPTURE(scene.wanted[r]);
      CHECK(reference.results[r].met().value_or(false));
      for (std::size_t i = 0; i < fast.results[r].numbers.size(); ++i) {
        const double value = fast.results[r].numbers[i].value;
        const ref::Estimate& truth = reference.results[r].numbers[i];
        CHECK(std::fabs(truth.error_of(value)) <= 1e-11 * std::fmax(std::fabs(value), 1e-4));
        CHECK(truth.proven);
      }
    }
  }
}

TEST_CASE("lengths and digits beyond the reference's solvers are refused by name") {
  data::Scene scene = scene_of(0.005, {data::ResultId::load});
  problem_of(scene).given = data::GivenLength{5.5};
  check_unsolvable(scene, "contact.length = 5.5: ");
  check_unsolvable(scene_of(0.25, {data::ResultId::load}), "digits = 15: ", 15);
  problem_of(scene).given = data::GivenLoad{-1};
  check_unsolvable(scene, "load.per_length = -1: must be finite and > 0");

  scene = scene_of(0.005, {data::ResultId::load});
  problem_of(scene).friction = data::Friction::full;
  problem_of(scene).given = data::GivenLength{5.5};
  check_unsolvable(scene, "contact.length = 5.5: ");
  problem_of(scene).given = data::GivenLength{5};
  check_unsolvable(scene, "digits = 101: must be from 16 to 100", 101);
  check_unsolvable(scene, "digits = 100: must be fewer", 100);
}

TEST_CASE("what takes the reference more than ten seconds is known before it starts") {
  const auto seconds = [](const char* name, int digits, std::size_t places) {
    data::Scene scene = data::load_scene(data::example_scene(name));
    scene.wanted = {data::ResultId::contact_length};
    if (auto* const nip = std::get_if<data::ElasticNipProblem>(&scene.system); nip != nullptr && places > 0) {
      scene.wanted = {data::ResultId::stress_across};
      nip->field = {std::vector<double>(places, 0), {0.5}};
    }
    return verify::likely_seconds_by_ref(scene, digits);
  };
  CHECK(seconds("thick-full-friction", 16, 0) < 1);
  CHECK(seconds("thick-full-friction", 16, 1000) > 10);
  CHECK(seconds("viscoelastic-short-memory", 16, 0) < 20);
  CHECK(seconds("viscoelastic-short-memory", 30, 0) > 10);
  const data::Scene inside = data::load_scene(data::example_scene("inside-full-friction"));
  CHECK(verify::likely_seconds_by_ref(inside, 30) > 10);  // all of it is the greatest shear and the field
  // Refused at once, or nothing that it knows of.
  CHECK(seconds("thick-full-friction", 101, 0) == 0);
  CHECK(seconds("thick-frictionless-line-loads", 30, 0) == 0);
  CHECK(seconds("half-space-line", 30, 0) == 0);
  CHECK(verify::warning_of_time(9).empty());
  CHECK(verify::warning_of_time(41.7) == "nipref: the reference needs about 42 s for this scene\n");
}
