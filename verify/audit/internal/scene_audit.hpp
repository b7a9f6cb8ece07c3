#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <nipref/fast/number/estimate.hpp>
#include <nipref/verify/audit/internal/drawn_scene.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {

/// What is audited, and by what.
struct SceneSolvers {
  std::function<SceneSolution<fast::Estimate>(const data::Scene&)> fast = solve;
  std::function<SceneSolution<ref::Estimate>(const data::Scene&, int digits)> ref = solve_by_ref;
};

/// What was found about one drawn scene. A number is a result, or one of a profile.
struct SceneFindings {
  std::uint64_t index = 0;
  std::string refused;              ///< why; nothing else then
  std::string failed;               ///< what was thrown that is no refusal
  std::size_t numbers = 0;          ///< that the scene wanted
  std::size_t unchecked = 0;        ///< with nothing better to compare with, and no identity
  std::size_t uncovered = 0;        ///< with an error larger than the estimates of both sides
  std::size_t miss_reported = 0;    ///< not as accurate as was asked, as `met` says
  std::size_t miss_unreported = 0;  ///< though `met` says they are
  double largest_ratio = 0;         ///< of the difference to the estimates of both sides
  std::string where;                ///< it was found
  std::string toml;                 ///< the scene
  /// Estimate over error, of the numbers for which that is known to a tenth of the estimate.
  std::vector<double> overestimates;
  double seconds = 0;  ///< for the scene itself
};

/// Solves scene `index` of `seed` as `solve` does, and compares each number with the reference (elastic
/// contact without friction, L/B up to 20; half-spaces, where lines differ a share only of what takes seconds), with the same nip at 1e-13, and with its
/// identities. A comparison with a truth of larger estimate, or an identity of twice the estimate, says
/// nothing, unless it contradicts.
SceneFindings audit_scene(const std::string& seed, std::uint64_t index, const SceneSolvers& solvers);

}  // namespace nipref::verify
