#include <nlohmann/json.hpp>

#include <nipref/data/scene/results.hpp>
#include <nipref/verify/cli/output.hpp>

#include "support/proven_pages.hpp"
#include "support/solved_scene.hpp"

using namespace nipref;

TEST_CASE("the reference counts its work, of the kernels that it needs") {
  for (const char* friction : {"none", "full"}) {
    const fast::Work work =
        verify::solve_by_ref(
            loaded_example("thick-frictionless", {{"wanted", R"(["load", "tangential_displacement"])"},
                                                  {"friction.model", friction},
                                                  {"profile.positions", "[-0.02, 0.0, 0.01, 0.5]"}}),
            20)
            .work;
    for (const std::size_t kernel : {0U, 2U}) CHECK(work.kernel_evaluations[kernel] > 0);
    CHECK((work.kernel_evaluations[5] > 0) == (std::string(friction) == "full"));
    CHECK(work.unknowns > 0);
  }
}

TEST_CASE("what the reference solves is proven, what fast solves is estimated, and both say so") {
  const auto json_of = [](const auto& solution) {
    return nlohmann::ordered_json::parse(verify::solution_json(solution).text());
  };
  const auto is_said = [&](const auto& solution, bool proven, std::size_t results) {
    const auto answer = json_of(solution).at("results");
    CHECK(answer.size() == results);
    for (const auto& result : answer) CHECK(result.at("proven") == proven);
  };
  const auto text_of = [](const auto& solution) {
    return verify::text_of("solve.txt", verify::solution_json(solution));
  };
  const auto loads = verify::solve_by_ref(loaded_example("thick-frictionless-line-loads"), 20);
  is_said(loads, true, loads.results.size());
  CHECK(contains(text_of(loads), " bound "));
  CHECK(!contains(text_of(loads), " error "));
  CHECK(json_of(loads).at("results").at("contact_length").at("error") ==
        loads["contact_length"].error_text());
  const auto free = verify::solve(loaded_example("thick-frictionless"));
  is_said(free, false, 4);
  CHECK(!contains(text_of(free), " bound "));
  // Exact zeros of the shear do not make a field proven.
  is_said(verify::solve_by_ref(loaded_example("inside-full-friction", {{"wanted", R"(["stress_shear"])"},
                                                                       {"field.positions", "[0.035]"},
                                                                       {"field.depths", "[0, 0.5]"}}),
                               16),
          false, 1);
}

TEST_CASE("what takes the reference more than ten seconds is known before it starts") {
  const auto seconds = [](const char* name, int digits, std::size_t places) {
    data::Scene scene = loaded_example(name);
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
  const data::Scene inside = loaded_example("inside-full-friction");
  CHECK(verify::likely_seconds_by_ref(inside, 30) > 10);  // for the greatest shear and the field
  // The time is 0 for scenes that are refused at once or whose time is not known.
  CHECK(seconds("thick-full-friction", 101, 0) == 0);
  CHECK(seconds("thick-frictionless-line-loads", 30, 0) == 0);
  CHECK(seconds("half-space-line", 30, 0) == 0);
  CHECK(verify::likely_seconds_by_ref(loaded_example("half-space-surface"), 20) == 3 * 2);
  CHECK(verify::warning_of_time(9).empty());
  CHECK(verify::warning_of_time(41.7) == "nipref: the reference needs about 42 s for this scene\n");
}

TEST_CASE("each result of a scene stands among the proven or the estimated of its kind of contact") {
  std::set<std::string> named;
  for (const TableRow& kind : rows_of_proven("contact")) {
    REQUIRE(kind.size() == 4);
    for (const std::string& name : names_in(kind[2] + kind[3])) named.insert(name);
  }
  for (const data::SceneResult& result : data::scene_results()) {
    CAPTURE(result.name);
    CHECK(named.erase(std::string(result.name)) == 1);
  }
  CHECK(named.empty());
}
