#include <nipref/data/scene/file.hpp>
#include <nipref/data/scene/results.hpp>
#include <nipref/verify/solve/solve.hpp>

#include "support/proven_pages.hpp"
#include "support/test.hpp"

using namespace nipref;

namespace {

const std::vector<TableRow> kinds = rows_of_proven("contact");

bool is_inside(const std::string& result) { return data::find_scene_result(result)->is_inside(); }

/// The example solved for these results, but those inside the sheet, which take long.
verify::SceneSolution<ref::Estimate> solved_for(const std::string& example,
                                                const std::vector<std::string>& names) {
  data::Scene scene = data::load_scene(data::example_scene(example));
  std::visit([](auto& problem) { problem.profile = data::Positions{{0.001}}; }, scene.system);
  scene.wanted.clear();
  for (const std::string& name : names) {
    if (!is_inside(name)) scene.wanted.push_back(data::find_scene_result(name)->id);
  }
  return verify::solve_by_ref(scene, 16);
}

}  // namespace

TEST_CASE("each result of a scene stands among the proven or the estimated of its kind of contact") {
  std::set<std::string> named;
  for (const TableRow& kind : kinds) {
    REQUIRE(kind.size() == 4);
    for (const std::string& name : names_in(kind[2] + kind[3])) named.insert(name);
  }
  for (const data::SceneResult& result : data::scene_results()) {
    CAPTURE(result.name);
    CHECK(named.erase(std::string(result.name)) == 1);
  }
  CHECK(named.empty());
}

TEST_CASE("what the pages say is proven of a kind of contact is proven, and no more") {
  for (const TableRow& kind : kinds) {
    const std::vector<std::string> proven = names_in(kind[2]), all = names_in(kind[2] + kind[3]);
    CAPTURE(kind[1]);
    const auto solution = solved_for(kind[1], all);
    for (const auto& result : solution.results) {
      const std::string name(result.what->name);
      CAPTURE(name);
      const bool is_proven =
          std::ranges::all_of(result.numbers, [](const ref::Estimate& x) { return x.proven; });
      CHECK(is_proven == (std::ranges::find(proven, name) != proven.end()));
    }
  }
}
