#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <nipref/verify/audit/internal/block.hpp>
#include <nipref/verify/audit/internal/contacts.hpp>
#include <nipref/verify/audit/internal/scene_tally.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// What was found in one block: numbers, which become text only where a file or another process takes them.
using BlockFindings = std::variant<QuantityFindings, std::vector<ContactAudit>, std::vector<SceneTally>>;

Json block_findings_json(const BlockFindings& found);

/// Work that falls into blocks, which may be done in any order, by any process, and more than once: what is found in a
/// block is always the same (but for seconds), and what is found in all of them together does not depend on the order.
class BlockWork {
 public:
  BlockWork() = default;
  BlockWork(const BlockWork&) = delete;
  BlockWork& operator=(const BlockWork&) = delete;
  virtual ~BlockWork() = default;

  /// Unlike that of all others in a run.
  [[nodiscard]] virtual std::string name() const = 0;
  [[nodiscard]] virtual std::size_t blocks() const = 0;
  /// A text that is another one where what is found in the blocks may be.
  [[nodiscard]] virtual std::string inputs() const = 0;
  /// Does a block on all cores. `on_progress`, which may be empty, is called with the part of it that is done. Interrupted
  /// if the process is.
  [[nodiscard]] virtual BlockFindings found_in(std::size_t block,
                                               const std::function<void(double part)>& on_progress) const = 0;
  /// The findings of which block_findings_json gave `json`. JsonMisfit for anything else.
  [[nodiscard]] virtual BlockFindings read_findings(const Json& json) const = 0;
  /// Adds what was found in a block that is not there yet.
  virtual void add(std::size_t block, const BlockFindings& found) = 0;
};

/// The audit of values of one quantity.
class QuantityWork : public BlockWork {
 public:
  /// Of fast's values. The quantity must outlive it. `keeps_points`: the result tells where errors lie, which takes
  /// memory for all points.
  QuantityWork(const Quantity& quantity, AuditOptions options, bool keeps_points = false);
  /// Of anybody's values.
  QuantityWork(const Quantity& quantity, AuditOptions options, Evaluator evaluator, bool is_fast,
               bool keeps_points);

  [[nodiscard]] std::string name() const override { return quantity_.name; }
  [[nodiscard]] std::size_t blocks() const override { return plan().blocks(); }
  [[nodiscard]] std::string inputs() const override { return plan().fingerprint(); }
  [[nodiscard]] BlockFindings found_in(std::size_t block,
                                       const std::function<void(double part)>& on_progress) const override;
  [[nodiscard]] BlockFindings read_findings(const Json& json) const override;
  void add(std::size_t block, const BlockFindings& found) override;

  /// Of the blocks that were added. BadInput if the reference refuses all points of all ranges.
  [[nodiscard]] AuditResult result() const;

 private:
  [[nodiscard]] const AuditPlan& plan() const;

  const Quantity& quantity_;
  const AuditOptions options_;
  Evaluator evaluator_;
  Comparator comparator_;
  bool keeps_points_;
  mutable std::unique_ptr<AuditPlan> plan_;  ///< made when it is asked for first: that takes a while
  QuantityFindings sum_;
};

/// The audit of hard cases of whole contacts.
class HardCasesWork : public BlockWork {
 public:
  [[nodiscard]] std::string name() const override { return "contacts"; }
  [[nodiscard]] std::size_t blocks() const override { return hard_case_groups; }
  [[nodiscard]] std::string inputs() const override { return "hard cases"; }
  [[nodiscard]] BlockFindings found_in(std::size_t block,
                                       const std::function<void(double part)>& on_progress) const override;
  [[nodiscard]] BlockFindings read_findings(const Json& json) const override;
  void add(std::size_t block, const BlockFindings& found) override;

  /// Of the blocks that were added.
  [[nodiscard]] std::vector<ContactAudit> result() const;

 private:
  std::map<std::size_t, std::vector<ContactAudit>> audits_;
};

/// The audit of random scenes of whole contacts.
class ScenesWork : public BlockWork {
 public:
  /// The first `count` of a seed, in blocks of so many at most.
  ScenesWork(std::size_t count, std::string seed, std::size_t most = scenes_of_block,
             SceneSolvers solvers = {});

  /// So few because they are slow.
  static constexpr std::size_t scenes_of_block = 32;

  [[nodiscard]] std::string name() const override { return "random scenes"; }
  [[nodiscard]] std::size_t blocks() const override { return blocks_.count; }
  [[nodiscard]] std::string inputs() const override;
  [[nodiscard]] BlockFindings found_in(std::size_t block,
                                       const std::function<void(double part)>& on_progress) const override;
  [[nodiscard]] BlockFindings read_findings(const Json& json) const override;
  void add(std::size_t block, const BlockFindings& found) override;

  /// Of the blocks that were added.
  [[nodiscard]] std::vector<SceneTally> result() const { return without_empty(tallies_); }

 private:
  std::string seed_;
  Blocks blocks_;
  SceneSolvers solvers_;
  std::vector<SceneTally> tallies_;  ///< one for each kind
};

}  // namespace nipref::verify
