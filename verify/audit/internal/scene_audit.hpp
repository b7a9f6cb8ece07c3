#pragma once
#include <cstdint>

#include <nipref/fast/number/estimate.hpp>
#include <nipref/verify/audit/internal/drawn_scene.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {

/// The solver that is audited, and the reference.
struct SceneSolvers {
  std::function<SceneSolution<fast::Estimate>(const data::Scene&)> fast = solve;
  std::function<SceneSolution<ref::Estimate>(const data::Scene&, int digits)> ref = solve_by_ref;
};

/// The findings about one drawn scene. A number is a result, or one number of a profile, list or field.
struct SceneFindings {
  std::uint64_t index = 0;
  std::string refused;            ///< the reason if the scene is refused; there are no other findings then
  std::string failed;             ///< the message of an exception that is no refusal
  std::size_t numbers = 0;        ///< numbers that the scene wants
  std::size_t unchecked = 0;      ///< numbers without a better value and without an identity to compare with
  std::size_t uncovered = 0;      ///< numbers whose error exceeds the sum of both estimates
  std::size_t miss_reported = 0;  ///< numbers that miss the accuracy, as `met` says
  std::size_t miss_unreported = 0;  ///< numbers that miss the accuracy although `met` says that they meet it
  double largest_ratio = 0;         ///< largest difference over the sum of both estimates
  std::string where;                ///< the number with the largest ratio
  std::string toml;                 ///< the scene
  /// Estimate over error, for the numbers whose error is known to a tenth of the estimate.
  std::vector<double> overestimates;
  double seconds = 0;  ///< for the scene itself

  /// What a tally stores of a scene that it keeps, see stored.hpp.
  static void members(auto& self, const auto& each) {
    each("index", self.index, "refused", self.refused, "failed", self.failed, "ratio", self.largest_ratio,
         "where", self.where, "scene", self.toml, "times", self.seconds);
  }
};

/// Solves scene `index` of `seed` as `solve` does, and compares each number with the reference (for elastic contacts
/// without friction and L/B up to 20, and for half-spaces; a part of them only where the reference takes seconds),
/// with the same nip solved to 1e-13, its peak with the pressure there, and with its variants. A number counts as checked if
/// the other value has a smaller error estimate, or for a variant one of less than twice the size, or if the two contradict
/// each other.
SceneFindings audit_scene(const std::string& seed, std::uint64_t index, const SceneSolvers& solvers);

/// An equivalent scene.
struct Variant {
  std::string name;
  DrawnScene scene;
  /// The number of the original scene that follows from the same number of this scene.
  std::function<fast::Estimate(const data::SceneResult& what, const fast::Estimate& number)> back =
      [](const data::SceneResult&, const fast::Estimate& number) { return number; };
};

/// The variants that the scene allows; `solved` is its solution.
/// - Units: lengths, moduli and times multiplied by small odd numbers, if all products are exact.
/// - Given back: the load (force) that was found for the length (span) is given, or the reverse. The estimate contains
///   the effect of that number's error, with exponents of the load's growth from 1 to 5.
/// - Elastic limit: a rolling sheet that is elastic, as a nip that does not roll.
/// - Mirror: elastic nips at -Y; half-spaces with direction and angles negated.
/// - Turned: the direction of motion on an isotropic surface.
/// - Isotropic limit: an isotropic half-space as a transversely isotropic one, if its moduli are exact.
std::vector<Variant> variants_of(const DrawnScene& drawn, const SceneSolution<fast::Estimate>& solved,
                                 Random& random);

}  // namespace nipref::verify
