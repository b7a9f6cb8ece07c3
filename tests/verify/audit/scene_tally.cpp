#include <nipref/verify/audit/internal/scene_audit.hpp>
#include <nipref/verify/audit/internal/stored.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/report/report.hpp>

#include "support/json_schema.hpp"

using namespace nipref;

namespace {

verify::SceneFindings findings(std::uint64_t index, double ratio, double seconds) {
  verify::SceneFindings found;
  found.index = index;
  found.numbers = 40;
  found.unchecked = 2;
  found.largest_ratio = ratio;
  found.where = "load";
  found.toml = "scene " + std::to_string(index) + "\n";
  found.seconds = seconds;
  found.overestimates = {3, 5};
  return found;
}

}  // namespace

TEST_CASE("findings are summed by kind, with the worst and the slowest scene of each") {
  const std::uint64_t kinds = verify::drawn_kinds().size();
  verify::SceneFindings refused, uncovered = findings(1 + kinds, 7, 0.1);
  refused.index = 2 * kinds;
  refused.refused = "must not";
  uncovered.uncovered = 3;
  const auto tallies = verify::tally(
      {findings(0, 0.5, 0.1), findings(kinds, 0.9, 0.2), refused, findings(1, 0.1, 0.3), uncovered});
  REQUIRE(tallies.size() == kinds);
  CHECK(verify::without_empty(tallies).size() == 2);
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
}

TEST_CASE("tallies of a kind are the same in any order, and as they are told") {
  const std::uint64_t kinds = verify::drawn_kinds().size();
  verify::SceneFindings refused = findings(3 * kinds, 0, 0.1), failed = findings(kinds, 0.5, 0.1);
  refused.refused = "must not";
  failed.failed = "a fault";
  const std::vector<verify::SceneFindings> all{findings(2 * kinds, 0.5, 0.3), refused, failed,
                                               findings(0, 0.1, 0.3)};
  const auto told = [](const verify::SceneTally& tally) { return verify::stored(tally).line(); };
  verify::SceneTally forward, backward;
  for (std::size_t i = 0; i < all.size(); ++i) {
    forward.add(all[i]);
    backward.add(verify::restored<verify::SceneTally>(
        verify::stored(verify::tally({all[all.size() - 1 - i]}).front())));
  }
  CHECK(told(forward) == told(backward));
  CHECK(forward.worst.index == kinds);
  CHECK(forward.slowest.index == 0);
  CHECK(forward.failure.failed == "a fault");
  CHECK(verify::scene_tally_json({forward}).text() == verify::scene_tally_json({backward}).text());
  CHECK_THROWS_AS(static_cast<void>(verify::restored<verify::SceneTally>(verify::Json::object())),
                  verify::JsonMisfit);
}

TEST_CASE("a kind is kept unless a scene failed, is not covered, or missed its accuracy without saying so") {
  const auto kept_with = [](auto change) {
    verify::SceneFindings found = findings(0, 0.5, 0.1);
    change(found);
    return verify::all_kept(verify::tally({found}));
  };
  CHECK(kept_with([](auto&) {}));
  CHECK(kept_with([](auto& found) { found.miss_reported = 9; }));
  CHECK_FALSE(kept_with([](auto& found) { found.miss_unreported = 1; }));
  CHECK_FALSE(kept_with([](auto& found) { found.uncovered = 1; }));
  CHECK_FALSE(kept_with([](auto& found) { found.failed = "broken"; }));
}

TEST_CASE("the worst scene of a kind that is not kept is printed, to be solved again") {
  verify::SceneFindings uncovered = findings(1, infinite, 0.1);
  uncovered.uncovered = 1;
  verify::SceneFindings failed = findings(2, 0, 0.1);
  failed.failed = "a fault";
  const auto tallies = verify::without_empty(verify::tally({findings(0, 0.5, 0.1), uncovered, failed}));
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
  const auto tallies = verify::tally(verify::audit_scenes(
      0, 2 * kinds, "few", [&](double done) { part = done; }, solvers));
  REQUIRE(tallies.size() == kinds);
  CHECK(part == 1);
  for (std::size_t k = 0; k < kinds; ++k) {
    CHECK(tallies[k].kind() == verify::drawn_kinds()[k]);
    CHECK(tallies[k].scenes == 2);
    CHECK(tallies[k].refused == 2);
    CHECK(tallies[k].refusal.refused == verify::audit_scene("few", k, solvers).refused);
  }
}
