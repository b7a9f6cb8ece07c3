#pragma once
#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/audit/internal/scene_audit.hpp>
#include <nipref/verify/audit/internal/stored.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// The division of items into blocks, whose sizes differ by at most one.
struct Blocks {
  std::size_t items, count;

  /// Blocks of at most `most` items; at least one block.
  Blocks(std::size_t all, std::size_t most) : items(all), count(all == 0 ? 1 : (all - 1) / most + 1) {}
  [[nodiscard]] std::size_t size(std::size_t block) const {
    return items / count + (block < items % count ? 1 : 0);
  }
  /// The number of its first item.
  [[nodiscard]] std::size_t first(std::size_t block) const {
    return block * (items / count) + std::min(block, items % count);
  }
};

/// The audit of one hard case, a contact solved in double.
struct ContactAudit {
  std::string system;  ///< method and friction
  double ratio;        ///< contact length over sheet thickness
  double poisson;
  int unknowns;
  std::optional<double> condition;    ///< of the line loads' matching matrix
  std::optional<double> oscillation;  ///< of the shear with friction, see fast::oscillation
  double allowed;                     ///< 1e-15 times the condition, or the solution's own estimate
  /// The relative error against ref, where ref solves the system: for line loads over the largest load, for a converged
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

/// The findings of audits.
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
  /// process is interrupted.
  virtual Json do_block(std::size_t block, const OnProgress& on_progress) = 0;
  /// Adds the findings that do_block has returned in another process. JsonMisfit for any other JSON.
  virtual void add(std::size_t block, const Json& found) = 0;
};

/// Compares an evaluator's values with the reference's.
class Comparator {
 public:
  /// The quantity and the options must outlive the comparator. Without an evaluator it compares fast. Where fast states
  /// the error of a value, this must then cover the error found.
  Comparator(const Quantity& quantity, Evaluator evaluator, const AuditOptions& options);

  /// The errors at the points that the reference does not refuse. Only these points are evaluated.
  [[nodiscard]] std::vector<Finding> operator()(std::span<const Point> points) const;
  /// The error of a value that was computed before; nothing if the reference refuses the point.
  [[nodiscard]] std::optional<Finding> operator()(const Point& point, double value) const;

 private:
  [[nodiscard]] std::optional<ref::Estimate> truth_at(const Point& point) const;
  [[nodiscard]] Finding finding(const Point& point, double value, const ref::Estimate& truth) const;

  const Quantity& quantity_;
  const AuditOptions& options_;
  Evaluator evaluator_;
  bool checks_own_error_;
};

/// The audit of values of one quantity. Each block draws its points from its own seed, "seed/I1/block/17", so that they
/// are the same whichever process computes the others. The listed points (hard cases, zeros, round arguments, the
/// caller's own points) are made once, from the seed "seed/I1/listed", and dealt to the blocks. Memory is needed for
/// this list, whose size does not depend on the number of points, and for one block.
class QuantityWork : public BlockWork {
 public:
  /// The audit of fast's values, or of those of an evaluator. The quantity must outlive it. With `keeps_points` the
  /// result has the distribution of the errors over the arguments, which takes memory for all points.
  QuantityWork(const Quantity& quantity, AuditOptions options, bool keeps_points = false,
               Evaluator evaluator = {});

  [[nodiscard]] std::string name() const override { return quantity_.name; }
  [[nodiscard]] std::size_t blocks() const override { return blocks_.count; }
  [[nodiscard]] std::string inputs() const override;
  Json do_block(std::size_t block, const OnProgress& on_progress) override;
  void add(std::size_t block, const Json& found) override;

  /// The points of a block before its local search.
  [[nodiscard]] std::vector<Point> points(std::size_t block) const;
  /// The number of points of a block; below, the number that its local search may use.
  [[nodiscard]] std::size_t size(std::size_t block) const { return blocks_.size(block); }
  [[nodiscard]] std::size_t searched(std::size_t block) const;
  /// The seed of a block's random numbers.
  [[nodiscard]] std::string seed(std::size_t block) const;

  /// The result from the blocks that were added. BadInput if the reference refuses all points.
  [[nodiscard]] AuditResult result() const;
  /// The findings before the search, if points are kept, in the blocks that this object has computed.
  [[nodiscard]] const std::vector<Finding>& findings() const { return kept_; }

 private:
  [[nodiscard]] const std::vector<Point>& listed() const;
  /// The worst finding of hill climbing: a step is taken when it finds a worse point.
  [[nodiscard]] Finding climbed(Finding start, std::size_t steps, const std::string& seed) const;

  const Quantity& quantity_;
  const AuditOptions options_;
  Comparator comparator_;
  bool keeps_points_;
  Blocks blocks_;
  std::size_t dense_;
  mutable std::optional<std::vector<Point>> listed_;  ///< made when it is first needed, as this takes time
  AuditTally sum_;
  std::vector<Finding> kept_;
};

/// Work whose findings are a list.
template <class Found>
class ListWork : public BlockWork {
 public:
  using Compute = std::function<std::vector<Found>(std::size_t block, const OnProgress& on_progress)>;
  /// `sum` combines the findings of blocks, in any order. Without it the findings are in the order of the blocks.
  ListWork(std::string name, std::size_t blocks, std::string inputs, Compute compute,
           std::vector<Found> (*sum)(const std::vector<Found>&) = nullptr)
      : name_(std::move(name)),
        blocks_(blocks),
        inputs_(std::move(inputs)),
        compute_(std::move(compute)),
        sum_(sum) {}

  [[nodiscard]] std::string name() const override { return name_; }
  [[nodiscard]] std::size_t blocks() const override { return blocks_; }
  [[nodiscard]] std::string inputs() const override { return inputs_; }
  Json do_block(std::size_t block, const OnProgress& on_progress) override {
    const std::vector<Found> found = compute_(block, on_progress);
    keep(block, found);
    return stored(found);
  }
  void add(std::size_t block, const Json& found) override {
    keep(block, restored<std::vector<Found>>(found));
  }

  /// The findings of the blocks that were added.
  [[nodiscard]] std::vector<Found> result() const {
    std::vector<Found> all;
    for (const auto& [block, found] : found_) all.insert(all.end(), found.begin(), found.end());
    return all;
  }

 private:
  void keep(std::size_t block, const std::vector<Found>& found) {
    std::vector<Found>& kept = found_[sum_ == nullptr ? block : 0];
    kept.insert(kept.end(), found.begin(), found.end());
    if (sum_ != nullptr) kept = sum_(kept);
  }

  std::string name_;
  std::size_t blocks_;
  std::string inputs_;
  Compute compute_;
  std::vector<Found> (*sum_)(const std::vector<Found>&);
  std::map<std::size_t, std::vector<Found>> found_;
};

/// The audit of hard cases of whole contacts, a group in each block.
std::unique_ptr<ListWork<ContactAudit>> hard_cases_work();
/// The audit of the first `count` random scenes of a seed.
std::unique_ptr<ListWork<SceneTally>> scenes_work(std::size_t count, const std::string& seed);

}  // namespace nipref::verify
