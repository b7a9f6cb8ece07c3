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

  /// "TABLE.KEY", or "KEY".
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

/// The kinds of scenes that data/statements/drawn_scenes.toml states, by name; scene `index` of any seed is of kind index modulo their number.
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
  double seconds = 0;        ///< for the scene itself

  /// See stored.hpp.
  static void members(auto& self, const auto& each) {
    each("index", self.index, "refused", self.refused, "failed", self.failed, "ratio", self.largest_ratio,
         "where", self.where, "scene", self.toml, "times", self.seconds);
  }
};

/// What is found about drawn scenes of one kind. A number is a result, or one number of a profile, list or field. The sum does
/// not depend on the order; among equally bad scenes the one with the lowest index is kept.
struct SceneTally {
  std::size_t scenes = 0, refused = 0, failed = 0;
  std::size_t numbers = 0;          ///< that the scenes want
  std::size_t unchecked = 0;        ///< without a better value and without an identity to compare with
  std::size_t uncovered = 0;        ///< whose error exceeds the sum of both estimates
  std::size_t miss_reported = 0;    ///< that miss the accuracy, as `met` says
  std::size_t miss_unreported = 0;  ///< that miss the accuracy although `met` says that they meet it
  /// Estimate over error, for the numbers whose error is known to a tenth of the estimate.
  ErrorTally overestimates = {};
  AuditedScene refusal = {}, failure = {};  ///< the first that is refused or fails, if there is one
  AuditedScene worst = {};                  ///< with the largest ratio of error to estimate
  AuditedScene slowest = {};

  void add(const SceneTally& more);
  /// Of a tally of this scene alone: counts and keeps it.
  void keep(const AuditedScene& scene);
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

/// Solves scene `index` of `seed` as `solve` does, and compares each number with the reference (for elastic contacts
/// without friction and L/B up to 20, and for half-spaces; a part of them only where the reference takes seconds),
/// with the same nip solved to 1e-13, its peak with the pressure there, and with its variants. A number counts as checked if
/// the other value has a smaller error estimate, or for a variant one of less than twice the size, or if the two contradict
/// each other.
SceneTally audit_scene(const std::string& seed, std::uint64_t index, const SceneSolvers& solvers);

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

/// Sums by kind, in the order of drawn_kinds(), without kinds that have no scenes.
std::vector<SceneTally> summed(const std::vector<SceneTally>& tallies);

/// Audits scenes `first` to `first + count - 1` of `seed` on all cores: a tally for each kind among them. Throws Interrupted if
/// the process is.
std::vector<SceneTally> audit_scenes(std::size_t first, std::size_t count, const std::string& seed,
                                     const OnProgress& on_progress, const SceneSolvers& solvers = {});

Json scene_tally_json(const std::vector<SceneTally>& tallies);

}  // namespace nipref::verify
