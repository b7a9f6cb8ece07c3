#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

constexpr std::array counts{&SceneTally::scenes,        &SceneTally::refused,        &SceneTally::failed,
                            &SceneTally::numbers,       &SceneTally::unchecked,      &SceneTally::uncovered,
                            &SceneTally::miss_reported, &SceneTally::miss_unreported};

constexpr std::size_t most_next_worst = 4;

/// A scene that a tally keeps by itself: the one with the lowest index among those with the largest rank, if this rank
/// is >= 0.
struct KeptScene {
  AuditedScene SceneTally::*scene;
  double (*rank)(const AuditedScene& scene);
};
constexpr KeptScene kept_scenes[] = {
    {&SceneTally::refusal, [](const AuditedScene& one) { return one.refused.empty() ? -1.0 : 1.0; }},
    {&SceneTally::failure, [](const AuditedScene& one) { return one.failed.empty() ? -1.0 : 1.0; }},
    {&SceneTally::slowest, [](const AuditedScene& one) { return one.seconds; }}};

Json worst_json(const AuditedScene& scene) {
  return {{"index", scene.index},
          {"where", Json::unless_empty(scene.where)},
          {"scene", Json::unless_empty(scene.toml)}};
}

Json next_worst_json(const AuditedScene& scene) {
  Json json = worst_json(scene);
  json.set("error_over_estimate", scene.largest_ratio);
  return json;
}

Json failure_json(const SceneTally& tally) {
  if (tally.failed == 0) return {};
  return {{"message", tally.failure.failed}, {"scene", tally.failure.toml}};
}

}  // namespace

void SceneTally::keep(const AuditedScene& audited) {
  refused = audited.refused.empty() ? 0 : 1;
  failed = audited.failed.empty() ? 0 : 1;
  for (const auto& [scene, rank] : kept_scenes)
    if (rank(audited) >= 0) this->*scene = audited;
  worst = audited;
}

void SceneTally::add(const SceneTally& more) {
  if (more.scenes == 0) return;
  if (scenes == 0) {
    *this = more;
    return;
  }
  for (const auto& [scene, rank] : kept_scenes) {
    AuditedScene& kept = this->*scene;
    const AuditedScene& other = more.*scene;
    if (rank(other) > rank(kept) || (rank(other) == rank(kept) && other.index < kept.index)) kept = other;
  }
  next_worst.insert(next_worst.end(), {worst, more.worst});
  next_worst.insert(next_worst.end(), more.next_worst.begin(), more.next_worst.end());
  std::ranges::sort(next_worst, {},
                    [](const AuditedScene& one) { return std::pair(-one.largest_ratio, one.index); });
  worst = next_worst.front();
  next_worst.erase(next_worst.begin());
  if (next_worst.size() > most_next_worst) next_worst.resize(most_next_worst);
  for (const auto count : counts) this->*count += more.*count;
  overestimates.add(more.overestimates);
}

std::optional<double> SceneTally::median_overestimate() const {
  return overestimates.count() == 0 ? std::nullopt : std::optional(overestimates.percentile(0.5));
}

std::vector<SceneTally> summed(const std::vector<SceneTally>& tallies) {
  std::vector<SceneTally> sums(drawn_kinds().size());
  for (const SceneTally& one : tallies) sums[one.worst.index % sums.size()].add(one);
  std::erase_if(sums, [](const SceneTally& one) { return one.scenes == 0; });
  return sums;
}

std::vector<SceneTally> audit_scenes(std::size_t first, std::size_t count, const std::string& seed,
                                     const OnProgress& on_progress, const SceneSolvers& solvers) {
  return summed(parallel_mapped(
      count, [&](std::size_t i) { return audit_scene(seed, first + i, solvers); }, on_progress));
}

std::unique_ptr<ListWork<SceneTally>> scenes_work(std::size_t count, const std::string& seed) {
  constexpr std::size_t scenes_of_block = 32;  // few, as scenes are slow
  const Blocks blocks(count, scenes_of_block);
  const auto audit_block = [=](std::size_t block, const OnProgress& on_progress) {
    return audit_scenes(blocks.first(block), blocks.size(block), seed, on_progress);
  };
  return std::make_unique<ListWork<SceneTally>>(
      "random scenes", blocks.count, fmt::format("{} scenes of {}", count, seed), audit_block, summed);
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
        {"worst", worst_json(tally.worst)},
        {"next_worst", json_list(tally.next_worst, next_worst_json)},
        {"passed", tally.kept()},
        {"_uncovered", tally.worst.largest_ratio > 0},
        {"times", {{"slowest_seconds", tally.slowest.seconds}, {"slowest_scene", tally.slowest.toml}}}};
  });
}

}  // namespace nipref::verify
