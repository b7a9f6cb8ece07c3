#include <nipref/verify/audit/internal/scene_audit.hpp>
#include <nipref/verify/audit/internal/stored.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/report/report.hpp>

#include "support/json_schema.hpp"

using namespace nipref;

namespace {

/// The findings about one scene. The scene is refused or fails only if a reason is given.
verify::SceneTally findings(std::uint64_t index, double ratio, double seconds,
                            const std::string& refused = "", const std::string& failed = "") {
  verify::SceneTally found{.scenes = 1, .numbers = 40, .unchecked = 2};
  found.overestimates.add(3);
  found.overestimates.add(5);
  found.keep({index, refused, failed, ratio, "load", "scene " + std::to_string(index) + "\n", seconds});
  return found;
}

}  // namespace

TEST_CASE("findings are summed by kind, with the worst five and the slowest scene of each") {
  const std::uint64_t kinds = verify::drawn_kinds().size();
  verify::SceneTally refused{.scenes = 1}, uncovered = findings(1 + kinds, 7, 0.1);
  refused.keep({.index = 2 * kinds, .refused = "must not"});
  uncovered.uncovered = 3;
  const auto tallies = verify::summed(
      {findings(0, 0.5, 0.1), findings(kinds, 0.9, 0.2), refused, findings(1, 0.1, 0.3), uncovered});
  REQUIRE(tallies.size() == 2);
  CHECK(tallies[0].kind() == verify::drawn_kinds()[0]);
  CHECK(tallies[0].scenes == 3);
  CHECK(tallies[0].refused == 1);
  CHECK(tallies[0].refusal.refused == "must not");
  CHECK(tallies[0].numbers == 80);
  CHECK(tallies[0].unchecked == 4);
  CHECK(tallies[0].median_overestimate() == 3);
  CHECK(tallies[0].worst.index == kinds);
  CHECK(tallies[0].slowest.index == kinds);
  CHECK(tallies[0].kept());
  CHECK(tallies[1].uncovered == 3);
  CHECK(tallies[1].worst.index == 1 + kinds);
  CHECK(tallies[1].slowest.index == 1);
  CHECK_FALSE(tallies[1].kept());
  CHECK_FALSE(verify::all_kept(tallies));
  CHECK(verify::summed({verify::SceneTally{}}).empty());
}

TEST_CASE("tallies of a kind are the same in any order, and restored as they were stored") {
  const std::uint64_t kinds = verify::drawn_kinds().size();
  const std::vector<verify::SceneTally> all{findings(2 * kinds, 0.5, 0.3),
                                            findings(3 * kinds, 0, 0.1, "must not"),
                                            findings(kinds, 0.5, 0.1, "", "a fault"),
                                            findings(0, 0.1, 0.3),
                                            findings(4 * kinds, 0.2, 0.1),
                                            findings(5 * kinds, 0.3, 0.1)};
  const auto told = [](const verify::SceneTally& tally) { return verify::stored(tally).line(); };
  verify::SceneTally forward, backward;
  for (std::size_t i = 0; i < all.size(); ++i) {
    forward.add(all[i]);
    backward.add(verify::restored<verify::SceneTally>(verify::stored(all[all.size() - 1 - i])));
  }
  CHECK(told(forward) == told(backward));
  CHECK(forward.worst.index == kinds);
  const auto indices = verify::mapped(forward.next_worst, &verify::AuditedScene::index);
  CHECK(indices == std::vector<std::uint64_t>{2 * kinds, 5 * kinds, 4 * kinds, 0});
  CHECK(forward.slowest.index == 0);
  CHECK(forward.failure.failed == "a fault");
  CHECK(verify::scene_tally_json({forward}).text() == verify::scene_tally_json({backward}).text());
  CHECK_THROWS_AS(static_cast<void>(verify::restored<verify::SceneTally>(verify::Json::object())),
                  verify::JsonMisfit);
}

TEST_CASE("a kind is kept unless a scene failed, is not covered, or missed its accuracy without saying so") {
  const auto kept_with = [](auto change) {
    verify::SceneTally found = findings(0, 0.5, 0.1);
    change(found);
    return verify::all_kept(verify::summed({found}));
  };
  CHECK(kept_with([](auto&) {}));
  CHECK(kept_with([](auto& found) { found.miss_reported = 9; }));
  CHECK_FALSE(kept_with([](auto& found) { found.miss_unreported = 1; }));
  CHECK_FALSE(kept_with([](auto& found) { found.uncovered = 1; }));
  CHECK_FALSE(kept_with([](auto& found) { found.failed = 1; }));
}

TEST_CASE("the worst scene of a kind that is not kept is printed, to be solved again") {
  verify::SceneTally uncovered = findings(1, infinite, 0.1);
  uncovered.uncovered = 1;
  const auto tallies =
      verify::summed({findings(0, 0.5, 0.1), uncovered, findings(1 + verify::drawn_kinds().size(), 0.25, 0.1),
                      findings(2, 0, 0.1, "", "a fault")});
  verify::Json members = verify::audits_json({{}, {}, tallies}, {});
  members.append({{"_of_contacts", true}, {"_of_nothing", false}});
  const std::string text = verify::text_of("audit.txt", members);
  CHECK(contains(text, "PASS"));
  CHECK(contains(text, "FAIL"));
  CHECK(contains(text, "scene 1\n"));
  CHECK(!contains(text, "scene 0\n"));
  CHECK(contains(text, "a fault\nscene 2\n"));

  const auto json = nlohmann::json::parse(verify::scene_tally_json(tallies).for_machines().text());
  for (const auto& row : json) CHECK(answer_schema().misfit(row, "scene_row") == "");
  CHECK(json[1]["largest_error_over_estimate"].is_null());
  CHECK(json[1]["worst"]["scene"] == "scene 1\n");
  CHECK(json[1]["next_worst"][0]["error_over_estimate"] == 0.25);
  CHECK(json[1]["next_worst"][0]["scene"] == fmt::format("scene {}\n", 1 + verify::drawn_kinds().size()));
  CHECK(json[0]["passed"] == true);
  CHECK(json[0]["first_failure"].is_null());
  CHECK(json[2]["first_failure"] == nlohmann::json{{"message", "a fault"}, {"scene", "scene 2\n"}});
}

TEST_CASE("a few random scenes of each kind are audited on all cores, each as it is by itself") {
  const std::size_t kinds = verify::drawn_kinds().size();
  verify::SceneSolvers solvers;
  solvers.fast = [](const data::Scene& scene) -> verify::SceneSolution<fast::Estimate> {
    throw data::BadInput("scene", scene.title, "must be another");
  };
  double part = 0;
  const auto tallies = verify::audit_scenes(
      0, 2 * kinds, "few", [&](double done) { part = done; }, solvers);
  REQUIRE(tallies.size() == kinds);
  CHECK(part == 1);
  for (std::size_t k = 0; k < kinds; ++k) {
    CHECK(tallies[k].kind() == verify::drawn_kinds()[k]);
    CHECK(tallies[k].scenes == 2);
    CHECK(tallies[k].refused == 2);
    CHECK(tallies[k].refusal.refused == verify::audit_scene("few", k, solvers).refusal.refused);
  }
}
