#include <nipref/verify/audit/internal/scene_audit.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

constexpr std::array counts{&SceneTally::scenes,        &SceneTally::refused,        &SceneTally::failed,
                            &SceneTally::numbers,       &SceneTally::unchecked,      &SceneTally::uncovered,
                            &SceneTally::miss_reported, &SceneTally::miss_unreported};

/// A scene that a tally keeps: of those with the largest rank the one with the lowest index. Below 0: none.
struct KeptScene {
  SceneFindings SceneTally::*scene;
  double (*rank)(const SceneFindings& findings);
};
constexpr KeptScene kept_scenes[] = {
    {&SceneTally::refusal, [](const SceneFindings& one) { return one.refused.empty() ? -1.0 : 1.0; }},
    {&SceneTally::failure, [](const SceneFindings& one) { return one.failed.empty() ? -1.0 : 1.0; }},
    {&SceneTally::worst, [](const SceneFindings& one) { return one.largest_ratio; }},
    {&SceneTally::slowest, [](const SceneFindings& one) { return one.seconds; }}};

SceneTally tally_of(const SceneFindings& findings) {
  SceneTally tally{.scenes = 1,
                   .refused = findings.refused.empty() ? 0U : 1U,
                   .failed = findings.failed.empty() ? 0U : 1U,
                   .numbers = findings.numbers,
                   .unchecked = findings.unchecked,
                   .uncovered = findings.uncovered,
                   .miss_reported = findings.miss_reported,
                   .miss_unreported = findings.miss_unreported};
  for (const auto& [scene, rank] : kept_scenes)
    if (rank(findings) >= 0) tally.*scene = findings;
  for (const double overestimate : findings.overestimates) tally.overestimates.add(overestimate);
  return tally;
}

Json failure_json(const SceneTally& tally) {
  if (tally.failed == 0) return {};
  return {{"message", tally.failure.failed}, {"scene", tally.failure.toml}};
}

}  // namespace

void SceneTally::add(const SceneFindings& findings) { add(tally_of(findings)); }

void SceneTally::add(const SceneTally& more) {
  if (more.scenes == 0) return;
  for (const auto& [scene, rank] : kept_scenes) {
    SceneFindings& kept = this->*scene;
    const SceneFindings& other = more.*scene;
    if (scenes == 0 || rank(other) > rank(kept) || (rank(other) == rank(kept) && other.index < kept.index))
      kept = other;
  }
  for (const auto count : counts) this->*count += more.*count;
  overestimates.add(more.overestimates);
}

std::optional<double> SceneTally::median_overestimate() const {
  return overestimates.count() == 0 ? std::nullopt : std::optional(overestimates.percentile(0.5));
}

std::vector<SceneTally> tally(const std::vector<SceneFindings>& findings) {
  std::vector<SceneTally> tallies(drawn_kinds().size());
  for (const SceneFindings& found : findings) tallies[found.index % tallies.size()].add(found);
  return tallies;
}

std::vector<SceneTally> without_empty(std::vector<SceneTally> tallies) {
  std::erase_if(tallies, [](const SceneTally& one) { return one.scenes == 0; });
  return tallies;
}

std::vector<SceneFindings> audit_scenes(std::size_t first, std::size_t count, const std::string& seed,
                                        const OnProgress& on_progress, const SceneSolvers& solvers) {
  return parallel_mapped(
      count, [&](std::size_t i) { return audit_scene(seed, first + i, solvers); }, on_progress);
}

Json scene_tally_json(const std::vector<SceneTally>& tallies) {
  return json_list(tallies, [](const SceneTally& tally) {
    return Json{
        {"kind", tally.kind()},
        {"scenes", tally.scenes},
        {"refused", tally.refused},
        {"first_refusal", Json::unless_empty(tally.refusal.refused)},
        {"failed", tally.failed},
        {"first_failure", failure_json(tally)},
        {"numbers", tally.numbers},
        {"unchecked", tally.unchecked},
        {"not_covered", tally.uncovered},
        {"miss_reported", tally.miss_reported},
        {"miss_unreported", tally.miss_unreported},
        {"median_overestimate", tally.median_overestimate()},
        {"largest_error_over_estimate", tally.worst.largest_ratio},
        {"worst",
         {{"index", tally.worst.index},
          {"where", Json::unless_empty(tally.worst.where)},
          {"scene", Json::unless_empty(tally.worst.toml)}}},
        {"passed", tally.kept()},
        {"_uncovered", tally.worst.largest_ratio > 0},
        {"times", {{"slowest_seconds", tally.slowest.seconds}, {"slowest_scene", tally.slowest.toml}}}};
  });
}

}  // namespace nipref::verify
