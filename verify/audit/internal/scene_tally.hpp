#pragma once
#include <nipref/verify/audit/error_tally.hpp>
#include <nipref/verify/audit/internal/scene_audit.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/json.hpp>
#include <nipref/verify/support/on_progress.hpp>

namespace nipref::verify {

/// Sums of the findings about the drawn scenes of one kind, which do not depend on their order. Among equally bad
/// scenes the one with the lowest index is kept.
struct SceneTally {
  std::size_t scenes = 0;
  std::size_t refused = 0, failed = 0;
  std::size_t numbers = 0, unchecked = 0, uncovered = 0, miss_reported = 0, miss_unreported = 0;
  ErrorTally overestimates = {};  ///< estimate over error
  SceneFindings refusal = {};     ///< the first refused scene, if there is one
  SceneFindings failure = {};     ///< the first scene that failed, if there is one
  SceneFindings worst = {};       ///< the scene with the largest ratio of error to estimate
  SceneFindings slowest = {};

  void add(const SceneFindings& findings);
  void add(const SceneTally& more);
  [[nodiscard]] std::string_view kind() const { return drawn_kinds()[worst.index % drawn_kinds().size()]; }
  [[nodiscard]] bool kept() const { return failed == 0 && uncovered == 0 && miss_unreported == 0; }
  [[nodiscard]] std::optional<double> median_overestimate() const;
  /// See stored.hpp; what depends on seconds is in "times".
  static void members(auto& self, const auto& each) {
    each("scenes", self.scenes, "refused", self.refused, "failed", self.failed, "numbers", self.numbers,
         "unchecked", self.unchecked, "uncovered", self.uncovered, "miss_reported", self.miss_reported,
         "miss_unreported", self.miss_unreported, "overestimates", self.overestimates, "refusal",
         self.refusal, "failure", self.failure, "worst", self.worst, "times", self.slowest);
  }
};

/// One tally for each kind, in the order of drawn_kinds().
std::vector<SceneTally> tally(const std::vector<SceneFindings>& findings);
/// The tallies that have scenes.
std::vector<SceneTally> without_empty(std::vector<SceneTally> tallies);

/// Audits scenes `first` to `first + count - 1` of `seed` on all cores. Throws Interrupted if the process is.
std::vector<SceneFindings> audit_scenes(std::size_t first, std::size_t count, const std::string& seed,
                                        const OnProgress& on_progress, const SceneSolvers& solvers = {});

Json scene_tally_json(const std::vector<SceneTally>& tallies);

bool all_kept(const std::vector<SceneTally>& tallies);

}  // namespace nipref::verify
