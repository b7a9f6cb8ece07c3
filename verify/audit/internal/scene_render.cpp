#include <fmt/format.h>

#include <nipref/verify/audit/internal/scene_tally.hpp>
#include <nipref/verify/support/internal/number_text.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

std::string worst_text(const SceneTally& tally) {
  std::string text;
  if (tally.failed > 0) {
    text += fmt::format("\n{}: {} scenes failed, the first with: {}\n{}", tally.kind, tally.failed,
                        tally.failure.failed, tally.failure.toml);
  }
  if (tally.worst.largest_ratio > 0) {
    text += fmt::format("\n{}: error over estimate {:.3g}: {}\n{}", tally.kind, tally.worst.largest_ratio,
                        tally.worst.where, tally.worst.toml);
  }
  return text;
}

Json failure_json(const SceneTally& tally) {
  if (tally.failed == 0) return {};
  return {{"message", tally.failure.failed}, {"scene", tally.failure.toml}};
}

}  // namespace

std::string scene_tally_text(const std::vector<SceneTally>& tallies) {
  TextTable table({"verdict", "random scenes", ">numbers", ">uncovered", ">err/est", ">est/err"});
  for (const SceneTally& tally : tallies) {
    table.add({verdict(tally.kept(), tally.kept() ? "kept" : "BROKEN"), std::string(tally.kind),
               fmt::format("{}", tally.numbers), fmt::format("{}", tally.uncovered),
               fmt::format("{:.3g}", tally.worst.largest_ratio), or_dash(tally.median_overestimate(), 3)});
    table.add_below(fmt::format(
        "{} scenes, {} refused; {} unchecked; accuracy missed {}, not reported {}; slowest {:.2g} s",
        tally.scenes, tally.refused, tally.unchecked, tally.miss_reported, tally.miss_unreported,
        tally.slowest.seconds));
  }
  std::string text = table.text();
  for (const SceneTally& tally : tallies) {
    if (!tally.kept()) text += worst_text(tally);
  }
  return text;
}

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
        {"kept", tally.kept()},
        {"times", {{"slowest_seconds", tally.slowest.seconds}, {"slowest_scene", tally.slowest.toml}}}};
  });
}

}  // namespace nipref::verify
