#pragma once
#include <nipref/verify/audit/internal/block.hpp>
#include <nipref/verify/audit/internal/scene_audit.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// One hard case of a contact in double.
struct ContactAudit {
  std::string system;  ///< method and friction
  double ratio;        ///< contact length over sheet thickness
  double poisson;
  int unknowns;
  std::optional<double> condition;    ///< of the line loads' matching matrix
  std::optional<double> oscillation;  ///< of the shear with friction, see fast::oscillation
  double allowed;                     ///< 1e-15 of the condition, or the solution's own estimate
  /// The error relative to ref, where ref has the system: of the line loads over the largest load, of a converged
  /// contact that of its load.
  std::optional<double> error = {};
  /// For frictionless line loads: the part of `error` caused by the rounding of the kernel values (the rest is the
  /// rounding of the solution, which the condition number magnifies), and the relative difference of the load from
  /// that of the continuous contact.
  std::optional<double> kernel_error = {};
  std::optional<double> discretisation_error = {};

  /// Nothing if there is no independent value to compare with.
  [[nodiscard]] std::optional<bool> kept() const {
    return error ? std::optional(*error <= allowed) : std::nullopt;
  }
  /// See stored.hpp.
  static void members(auto& self, const auto& each) {
    each("system", self.system, "length_over_thickness", self.ratio, "poisson", self.poisson, "unknowns",
         self.unknowns, "condition", self.condition, "oscillation", self.oscillation, "error", self.error,
         "allowed", self.allowed, "kernel_error", self.kernel_error, "discretisation_error",
         self.discretisation_error);
  }
};

/// The hard cases: L/B from 1e-4 to 1e3, Poisson's ratio from -0.9 to 0.5, up to 500 elements a side. A group has one
/// kind of friction, one Poisson's ratio, one L/B, and all numbers of elements.
inline constexpr std::size_t hard_case_groups = 30;
std::vector<ContactAudit> audit_hard_cases(std::size_t group);

Json contact_audit_json(const std::vector<ContactAudit>& audits);

/// What audits have found.
struct Audited {
  std::vector<AuditResult> quantities;
  std::vector<ContactAudit> hard_cases;
  std::vector<SceneTally> scenes;

  [[nodiscard]] bool kept() const { return all_kept(quantities) && all_kept(hard_cases) && all_kept(scenes); }
};

/// Work in blocks, which may be computed in any order, by any process, and more than once: the findings of a block are
/// always the same (except for seconds), and their sum does not depend on the order.
class BlockWork {
 public:
  BlockWork() = default;
  BlockWork(const BlockWork&) = delete;
  BlockWork& operator=(const BlockWork&) = delete;
  virtual ~BlockWork() = default;

  /// A name that is unique in a run.
  [[nodiscard]] virtual std::string name() const = 0;
  [[nodiscard]] virtual std::size_t blocks() const = 0;
  /// A text that differs wherever the findings of the blocks may differ.
  [[nodiscard]] virtual std::string inputs() const = 0;
  /// Computes a block on all cores, adds its findings, and returns them as they are stored. Throws Interrupted if the
  /// process is.
  virtual Json do_block(std::size_t block, const OnProgress& on_progress) = 0;
  /// Adds what do_block has returned in another process. JsonMisfit for anything else.
  virtual void add(std::size_t block, const Json& found) = 0;
};

/// The audit of values of one quantity.
class QuantityWork : public BlockWork {
 public:
  /// The audit of fast's values, or of those of an evaluator. The quantity must outlive it. With `keeps_points` the
  /// result has the distribution of the errors over the arguments, which takes memory for all points.
  QuantityWork(const Quantity& quantity, AuditOptions options, bool keeps_points = false,
               Evaluator evaluator = {});

  [[nodiscard]] std::string name() const override { return quantity_.name; }
  [[nodiscard]] std::size_t blocks() const override { return plan().blocks(); }
  [[nodiscard]] std::string inputs() const override { return plan().fingerprint(); }
  Json do_block(std::size_t block, const OnProgress& on_progress) override;
  void add(std::size_t block, const Json& found) override;

  /// The result from the blocks that were added. BadInput if the reference refuses all points.
  [[nodiscard]] AuditResult result() const;

 private:
  [[nodiscard]] const AuditPlan& plan() const;

  const Quantity& quantity_;
  const AuditOptions options_;
  Comparator comparator_;
  bool keeps_points_;
  mutable std::unique_ptr<AuditPlan> plan_;  ///< made when it is first needed, as this takes time
  AuditTally sum_;
  Compared kept_;  ///< the points, if they are kept
};

/// The audit of hard cases of whole contacts.
class HardCasesWork : public BlockWork {
 public:
  [[nodiscard]] std::string name() const override { return "contacts"; }
  [[nodiscard]] std::size_t blocks() const override { return hard_case_groups; }
  [[nodiscard]] std::string inputs() const override { return "hard cases"; }
  Json do_block(std::size_t block, const OnProgress& on_progress) override;
  void add(std::size_t block, const Json& found) override;

  /// Of the blocks that were added.
  [[nodiscard]] std::vector<ContactAudit> result() const;

 private:
  std::map<std::size_t, std::vector<ContactAudit>> audits_;
};

/// The audit of random scenes of whole contacts.
class ScenesWork : public BlockWork {
 public:
  /// The first `count` scenes of a seed, in blocks of at most `most`.
  ScenesWork(std::size_t count, std::string seed, std::size_t most = scenes_of_block,
             SceneSolvers solvers = {});

  /// Scenes are slow, so that their blocks are small.
  static constexpr std::size_t scenes_of_block = 32;

  [[nodiscard]] std::string name() const override { return "random scenes"; }
  [[nodiscard]] std::size_t blocks() const override { return blocks_.count; }
  [[nodiscard]] std::string inputs() const override;
  Json do_block(std::size_t block, const OnProgress& on_progress) override;
  void add(std::size_t block, const Json& found) override;

  /// Of the blocks that were added.
  [[nodiscard]] std::vector<SceneTally> result() const { return without_empty(tallies_); }

 private:
  void add(const std::vector<SceneTally>& kinds);

  std::string seed_;
  Blocks blocks_;
  SceneSolvers solvers_;
  std::vector<SceneTally> tallies_;  ///< one for each kind
};

}  // namespace nipref::verify
