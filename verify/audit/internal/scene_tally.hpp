#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/audit/internal/error_tally.hpp>
#include <nipref/verify/audit/internal/scene_audit.hpp>
#include <nipref/verify/support/json.hpp>
#include <nipref/verify/support/on_progress.hpp>

namespace nipref::verify {

/// Sums of the findings about the drawn scenes of one kind, which do not depend on their order. Among equally bad
/// scenes the one with the lowest index is kept.
struct SceneTally {
  std::string_view kind = {};
  std::size_t scenes = 0;
  std::size_t refused = 0, failed = 0;
  std::size_t numbers = 0, unchecked = 0, uncovered = 0, miss_reported = 0, miss_unreported = 0;
  ErrorTally overestimates = {};  ///< estimate over error
  SceneFindings refusal = {};     ///< the first refused scene, if refused > 0
  SceneFindings failure = {};     ///< the first scene that failed, if failed > 0
  SceneFindings worst = {};       ///< the scene with the largest ratio of error to estimate
  SceneFindings slowest = {};

  void add(const SceneFindings& findings);
  void add(const SceneTally& more);
  [[nodiscard]] bool kept() const { return failed == 0 && uncovered == 0 && miss_unreported == 0; }
  [[nodiscard]] std::optional<double> median_overestimate() const;
};

/// One tally for each kind, in the order of drawn_kinds().
std::vector<SceneTally> tally(const std::vector<SceneFindings>& findings);
/// The tallies that have scenes.
std::vector<SceneTally> without_empty(std::vector<SceneTally> tallies);

/// Audits scenes `first` to `first + count - 1` of `seed` on all cores. Throws Interrupted if the process is.
std::vector<SceneFindings> audit_scenes(std::size_t first, std::size_t count, const std::string& seed,
                                        const OnProgress& on_progress, const SceneSolvers& solvers = {});

/// A tally as it is written to a run's folder; seconds are in "times".
Json scene_tally_found(const SceneTally& tally);
/// Reads what scene_tally_found has written. JsonMisfit for anything else.
SceneTally scene_tally_of(const Json& found);

Json scene_tally_json(const std::vector<SceneTally>& tallies);

bool all_kept(const std::vector<SceneTally>& tallies);

}  // namespace nipref::verify
