#include <nipref/verify/audit/internal/stored.hpp>
#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>

namespace nipref::verify {

QuantityWork::QuantityWork(const Quantity& quantity, AuditOptions options, bool keeps_points,
                           Evaluator evaluator)
    : quantity_(quantity),
      options_(std::move(options)),
      comparator_(quantity, std::move(evaluator), options_),
      keeps_points_(keeps_points) {}

const AuditPlan& QuantityWork::plan() const {
  if (!plan_) plan_ = std::make_unique<AuditPlan>(quantity_, options_);
  return *plan_;
}

Json QuantityWork::do_block(std::size_t block, const OnProgress& on_progress) {
  const AuditTally found =
      audit_block(plan(), comparator_, block, on_progress, keeps_points_ ? &kept_ : nullptr);
  sum_.add(found, block);
  return stored(found);
}

void QuantityWork::add(std::size_t block, const Json& found) {
  const auto tally = restored<AuditTally>(found);
  if (tally.worst.size() != quantity_.arguments.size() && tally.errors.count() > 0) throw JsonMisfit("worst");
  sum_.add(tally, block);
}

AuditResult QuantityWork::result() const {
  return result_of(quantity_, options_, sum_, kept_, plan().points(0).front());
}

Json HardCasesWork::do_block(std::size_t block, const OnProgress& /*on_progress*/) {
  stop_if_interrupted();
  return stored(audits_[block] = audit_hard_cases(block));
}

void HardCasesWork::add(std::size_t block, const Json& found) {
  audits_[block] = restored<std::vector<ContactAudit>>(found);
}

std::vector<ContactAudit> HardCasesWork::result() const {
  std::vector<ContactAudit> all;
  for (const auto& [block, audits] : audits_) all.insert(all.end(), audits.begin(), audits.end());
  return all;
}

ScenesWork::ScenesWork(std::size_t count, std::string seed, std::size_t most, SceneSolvers solvers)
    : seed_(std::move(seed)),
      blocks_(count, most),
      solvers_(std::move(solvers)),
      tallies_(drawn_kinds().size()) {}

std::string ScenesWork::inputs() const { return fmt::format("{} scenes of {}", blocks_.items, seed_); }

Json ScenesWork::do_block(std::size_t block, const OnProgress& on_progress) {
  const std::vector<SceneTally> found = without_empty(
      tally(audit_scenes(blocks_.first(block), blocks_.size(block), seed_, on_progress, solvers_)));
  add(found);
  return stored(found);
}

void ScenesWork::add(std::size_t /*block*/, const Json& found) {
  add(restored<std::vector<SceneTally>>(found));
}

void ScenesWork::add(const std::vector<SceneTally>& kinds) {
  for (const SceneTally& kind : kinds) tallies_[kind.worst.index % tallies_.size()].add(kind);
}

}  // namespace nipref::verify
