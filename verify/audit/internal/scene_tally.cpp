
#include <algorithm>
#include <array>

#include <nipref/verify/audit/internal/scene_tally.hpp>
#include <nipref/verify/support/internal/parallel.hpp>
#include <nipref/verify/support/mapped.hpp>

namespace nipref::verify {
namespace {

constexpr std::array counts{&SceneTally::scenes,        &SceneTally::refused,        &SceneTally::failed,
                            &SceneTally::numbers,       &SceneTally::unchecked,      &SceneTally::uncovered,
                            &SceneTally::miss_reported, &SceneTally::miss_unreported};

/// Keeps the findings with the larger member or, if they are equal, with the lower index.
template <class Member>
void take_worse(SceneFindings& kept, bool is_there, const SceneFindings& other, bool other_is_there,
                Member member) {
  if (!other_is_there) return;
  if (is_there &&
      (kept.*member > other.*member || (kept.*member == other.*member && kept.index < other.index)))
    return;
  kept = other;
}

void take_first(SceneFindings& kept, bool is_there, const SceneFindings& other, bool other_is_there) {
  if (other_is_there && (!is_there || other.index < kept.index)) kept = other;
}

SceneTally tally_of(const SceneFindings& findings) {
  SceneTally tally{.kind = drawn_kinds()[findings.index % drawn_kinds().size()],
                   .scenes = 1,
                   .refused = findings.refused.empty() ? 0U : 1U,
                   .failed = findings.failed.empty() ? 0U : 1U,
                   .numbers = findings.numbers,
                   .unchecked = findings.unchecked,
                   .uncovered = findings.uncovered,
                   .miss_reported = findings.miss_reported,
                   .miss_unreported = findings.miss_unreported,
                   .refusal = findings,
                   .failure = findings,
                   .worst = findings,
                   .slowest = findings};
  for (const double overestimate : findings.overestimates) tally.overestimates.add(overestimate);
  return tally;
}

Json findings_found(const SceneFindings& findings) {
  return {{"index", findings.index},
          {"refused", findings.refused},
          {"failed", findings.failed},
          {"ratio", exact_json(findings.largest_ratio)},
          {"where", findings.where},
          {"scene", findings.toml},
          {"times", {{"seconds", exact_json(findings.seconds)}}}};
}

SceneFindings findings_of(const Json& found) {
  SceneFindings findings;
  findings.index = found.at("index").as_count();
  findings.refused = found.at("refused").as_text();
  findings.failed = found.at("failed").as_text();
  findings.largest_ratio = exact_double(found.at("ratio"));
  findings.where = found.at("where").as_text();
  findings.toml = found.at("scene").as_text();
  findings.seconds = exact_double(found.at("times").at("seconds"));
  return findings;
}

}  // namespace

void SceneTally::add(const SceneFindings& findings) { add(tally_of(findings)); }

void SceneTally::add(const SceneTally& more) {
  if (more.scenes == 0) return;
  take_first(refusal, refused > 0, more.refusal, more.refused > 0);
  take_first(failure, failed > 0, more.failure, more.failed > 0);
  take_worse(worst, scenes > 0, more.worst, true, &SceneFindings::largest_ratio);
  take_worse(slowest, scenes > 0, more.slowest, true, &SceneFindings::seconds);
  kind = more.kind;
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

Json scene_tally_found(const SceneTally& tally) {
  return {{"counts", mapped<Json>(counts, [&](auto count) { return tally.*count; })},
          {"overestimates", tally.overestimates.json()},
          {"refusal", tally.refused > 0 ? findings_found(tally.refusal) : Json()},
          {"failure", tally.failed > 0 ? findings_found(tally.failure) : Json()},
          {"worst", findings_found(tally.worst)},
          {"times", {{"slowest", findings_found(tally.slowest)}}}};
}

SceneTally scene_tally_of(const Json& found) {
  const std::vector<Json> numbers = found.at("counts").items();
  if (numbers.size() != counts.size()) throw JsonMisfit("counts");
  SceneTally tally;
  for (std::size_t i = 0; i < counts.size(); ++i) tally.*counts[i] = numbers[i].as_count();
  tally.overestimates = ErrorTally::of(found.at("overestimates"));
  if (tally.refused > 0) tally.refusal = findings_of(found.at("refusal"));
  if (tally.failed > 0) tally.failure = findings_of(found.at("failure"));
  tally.worst = findings_of(found.at("worst"));
  tally.slowest = findings_of(found.at("times").at("slowest"));
  tally.kind = drawn_kinds()[tally.worst.index % drawn_kinds().size()];
  return tally;
}

bool all_kept(const std::vector<SceneTally>& tallies) {
  return std::ranges::all_of(tallies, &SceneTally::kept);
}

namespace {

Json failure_json(const SceneTally& tally) {
  if (tally.failed == 0) return {};
  return {{"message", tally.failure.failed}, {"scene", tally.failure.toml}};
}

}  // namespace

Json scene_tally_json(const std::vector<SceneTally>& tallies) {
  return json_list(tallies, [](const SceneTally& tally) {
    return Json{
        {"kind", tally.kind},
        {"scenes", tally.scenes},
        {"refused", tally.refused},
        {"first_refusal", Json::unless_empty(tally.refused > 0 ? tally.refusal.refused : "")},
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
