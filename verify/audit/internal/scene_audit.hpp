#pragma once
#include <cstdint>

#include <nipref/data/scene/scene.hpp>
#include <nipref/fast/number/estimate.hpp>
#include <nipref/verify/audit/error_tally.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/json.hpp>
#include <nipref/verify/support/on_progress.hpp>
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {

/// A scene as the keys of its TOML file, so that single keys can be changed and the scene is read exactly as by
/// `solve`.
class DrawnScene {
 public:
  using Value = std::variant<double, std::string, std::vector<double>, std::vector<data::ResultId>>;

  /// Sets the key "TABLE.KEY" or "KEY".
  void set(const std::string& key, Value value) { keys_.insert_or_assign(key, std::move(value)); }
  void remove(const std::string& key) { keys_.erase(key); }
  [[nodiscard]] bool has(const std::string& key) const { return keys_.contains(key); }
  /// The value of a key, which must have this type.
  [[nodiscard]] double number(const std::string& key) const { return std::get<double>(keys_.at(key)); }
  [[nodiscard]] std::string text(const std::string& key) const {
    return std::get<std::string>(keys_.at(key));
  }
  [[nodiscard]] std::vector<double> numbers(const std::string& key) const {
    return std::get<std::vector<double>>(keys_.at(key));
  }
  [[nodiscard]] const std::vector<data::ResultId>& wanted() const {
    return std::get<std::vector<data::ResultId>>(keys_.at("wanted"));
  }
  void set_wanted(std::vector<data::ResultId> results) { set("wanted", std::move(results)); }
  [[nodiscard]] std::map<std::string, Value>& keys() { return keys_; }

  [[nodiscard]] std::string toml() const;
  /// BadInput as from load_scene.
  [[nodiscard]] data::Scene scene() const;

 private:
  std::map<std::string, Value> keys_;
};

/// The names of the kinds of scenes in data/statements/drawn_scenes.toml. The kind of scene `index` of any seed has the
/// number `index` modulo the number of kinds.
const std::vector<std::string_view>& drawn_kinds();

/// Scene number `index` of `seed`, which is the same at each call. The domain: L/B 1e-4 to 1e3, R/B 1 to 1e4,
/// Poisson's ratio -0.9 to 0.4999, relaxation lengths 1e-8 to 1e8 contact lengths, speeds up to 1 - 1e-9 of the
/// critical one, ratios of curvatures 1e-4 to 1e4, accuracies 1e-2 to 1e-13. The scene wants all results of its kind.
/// Every other scene has numbers of 34 bits, see variants_of. Some scenes are refused when they are read or solved.
DrawnScene draw_scene(const std::string& seed, std::uint64_t index);

/// The solver that is audited, and the reference.
struct SceneSolvers {
  std::function<SceneSolution<fast::Estimate>(const data::Scene&)> fast = solve;
  std::function<SceneSolution<ref::Estimate>(const data::Scene&, int digits)> ref = solve_by_ref;
};

/// A drawn scene that an audit keeps.
struct AuditedScene {
  std::uint64_t index = 0;
  std::string refused = {};  ///< the reason if the scene is refused; nothing else is found then
  std::string failed = {};   ///< the message of an exception that is no refusal
  double largest_ratio = 0;  ///< largest difference over the sum of both estimates
  std::string where = {};    ///< the number with the largest ratio
  std::string toml = {};     ///< the scene
  double seconds = 0;        ///< time to solve the scene itself

  /// See stored.hpp.
  static void members(auto& self, const auto& each) {
    each("index", self.index, "refused", self.refused, "failed", self.failed, "ratio", self.largest_ratio,
         "where", self.where, "scene", self.toml, "times", self.seconds);
  }
};

/// The findings about drawn scenes of one kind. A number is a result, or one number of a profile, list or field. The
/// sum does not depend on the order; among equally bad scenes those with the lowest indices are kept.
struct SceneTally {
  std::size_t scenes = 0, refused = 0, failed = 0;
  std::size_t numbers = 0;          ///< numbers that the scenes want
  std::size_t unchecked = 0;        ///< numbers without a better value or an identity to compare with
  std::size_t uncovered = 0;        ///< numbers whose error exceeds the sum of both estimates
  std::size_t miss_reported = 0;    ///< numbers that miss the accuracy, as `met` says
  std::size_t miss_unreported = 0;  ///< numbers that miss the accuracy although `met` says otherwise
  /// Estimate over error, for the numbers whose error is known to a tenth of the estimate.
  ErrorTally overestimates = {};
  AuditedScene refusal = {}, failure = {};  ///< the first scene that is refused or fails, if there is one
  AuditedScene slowest = {};
  AuditedScene worst = {};                    ///< the scene with the largest ratio of error to estimate
  std::vector<AuditedScene> next_worst = {};  ///< up to four others, those with the next largest ratios

  void add(const SceneTally& more);
  /// Counts and keeps a scene in a tally that is of this scene alone.
  void keep(const AuditedScene& scene);
  [[nodiscard]] std::string_view kind() const { return drawn_kinds()[worst.index % drawn_kinds().size()]; }
  [[nodiscard]] bool kept() const { return failed == 0 && uncovered == 0 && miss_unreported == 0; }
  [[nodiscard]] std::optional<double> median_overestimate() const;
  /// See stored.hpp; what depends on seconds is in "times".
  static void members(auto& self, const auto& each) {
    each("scenes", self.scenes, "refused", self.refused, "failed", self.failed, "numbers", self.numbers,
         "unchecked", self.unchecked, "uncovered", self.uncovered, "miss_reported", self.miss_reported,
         "miss_unreported", self.miss_unreported, "overestimates", self.overestimates, "refusal",
         self.refusal, "failure", self.failure, "worst", self.worst, "next_worst", self.next_worst, "times",
         self.slowest);
  }
};

/// Solves scene `index` of `seed` as `solve` does. Compares each number with the reference, for nips with L/B up to 20
/// and for half-spaces, but only for a share of the scenes where the reference takes seconds. Compares nips with the
/// same nip solved to 1e-13, and the peak pressure with the pressure at its position. Compares each scene with its
/// variants. A number counts as checked if the other value's error estimate is no larger than its own (for variants and
/// peaks, than twice its own), or if the two values contradict each other.
SceneTally audit_scene(const std::string& seed, std::uint64_t index, const SceneSolvers& solvers);

/// An equivalent scene.
struct Variant {
  std::string name;
  DrawnScene scene;
  /// Converts a number of this scene to the same number of the original scene.
  std::function<fast::Estimate(const data::SceneResult& what, const fast::Estimate& number)> back =
      [](const data::SceneResult&, const fast::Estimate& number) { return number; };
};

/// The variants that the scene allows; `solved` is its solution.
/// - Units: lengths, moduli and times multiplied by small odd numbers, if all products are exact.
/// - Given back: the load (force) that was found for the length (span) is given, or the reverse. The estimate includes
///   the effect of this number's error; the load grows with the length to a power from 1 to 5.
/// - Elastic limit: a rolling sheet that is elastic, as a nip that does not roll.
/// - Mirror: elastic nips at the positions -Y; half-spaces with direction and angles negated.
/// - Turned: another direction of motion on a surface whose response is the same in all directions.
/// - Isotropic limit: an isotropic half-space as a transversely isotropic one, if its moduli are exact.
std::vector<Variant> variants_of(const DrawnScene& drawn, const SceneSolution<fast::Estimate>& solved,
                                 Random& random);

/// The sums of the tallies of each kind, in the order of drawn_kinds(), without kinds that have no scenes.
std::vector<SceneTally> summed(const std::vector<SceneTally>& tallies);

/// Audits scenes `first` to `first + count - 1` of `seed` on all cores. Returns a tally for each kind among them.
/// Throws Interrupted if the process is interrupted.
std::vector<SceneTally> audit_scenes(std::size_t first, std::size_t count, const std::string& seed,
                                     const OnProgress& on_progress, const SceneSolvers& solvers = {});

Json scene_tally_json(const std::vector<SceneTally>& tallies);

}  // namespace nipref::verify
