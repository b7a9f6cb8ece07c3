#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/audit/internal/scene_audit.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// What was found about the drawn scenes of one kind: sums of SceneFindings.
struct SceneTally {
  std::string_view kind;
  std::size_t scenes = 0;
  std::size_t refused = 0, failed = 0;
  std::size_t numbers = 0, unchecked = 0, uncovered = 0, missed_said = 0, missed_unsaid = 0;
  std::optional<double> median_overestimate;
  std::string refusal;    ///< the first one
  SceneFindings failure;  ///< likewise
  SceneFindings worst;    ///< that with the largest ratio of error to estimate
  SceneFindings slowest;

  [[nodiscard]] bool kept() const { return failed == 0 && uncovered == 0 && missed_unsaid == 0; }
};

/// One for each kind of which there are findings.
std::vector<SceneTally> tally(const std::vector<SceneFindings>& findings);

/// Audits the first `count` scenes of `seed` on all cores; those that are finished, if the process is
/// interrupted. progress(part done) is called now and then.
std::vector<SceneTally> audit_scenes(std::size_t count, const std::string& seed,
                                     const std::function<void(double)>& progress,
                                     const SceneSolvers& solvers = {});

/// A table, and below it the worst scene of each kind that has not kept its estimates.
std::string scene_tally_text(const std::vector<SceneTally>& tallies);
Json scene_tally_json(const std::vector<SceneTally>& tallies);

bool all_kept(const std::vector<SceneTally>& tallies);

}  // namespace nipref::verify
