#include <fmt/format.h>

#include <iterator>
#include <utility>

#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>

namespace nipref::verify {

QuantityWork::QuantityWork(const Quantity& quantity, AuditOptions options)
    : quantity_(quantity),
      options_(std::move(options)),
      evaluator_(fast_evaluator(quantity, options_.accuracy)),
      judge_(quantity, evaluator_, options_, !options_.ranges.empty(), true) {}

const AuditPlan& QuantityWork::plan() const {
  if (!plan_) plan_ = std::make_unique<AuditPlan>(quantity_, options_);
  return *plan_;
}

Json QuantityWork::found_in(std::size_t block, const std::function<void(double part)>& told) const {
  const auto points = static_cast<double>(plan().size(block));
  const auto of_points = [&](std::size_t done) { told(static_cast<double>(done) / points); };
  return audit_block(quantity_, options_.ranges, judge_, plan(), block,
                     told ? std::function<void(std::size_t)>(of_points) : nullptr)
      .json();
}

void QuantityWork::add(std::size_t block, const Json& found) {
  AuditTally tally = AuditTally::of(found, quantity_.arguments.size());
  tally.worst_block = block;
  tally_.add(tally);
}

AuditResult QuantityWork::result() const {
  return result_of(quantity_, options_, tally_, plan().points(0).front());
}

Json HardCasesWork::found_in(std::size_t block, const std::function<void(double part)>& /*told*/) const {
  stop_if_interrupted();
  return json_list(audit_hard_cases(block), contact_audit_found);
}

void HardCasesWork::add(std::size_t block, const Json& found) {
  std::vector<ContactAudit> audits;
  for (const Json& audit : found.items()) audits.push_back(contact_audit_of(audit));
  audits_.emplace(block, std::move(audits));
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

Json ScenesWork::found_in(std::size_t block, const std::function<void(double part)>& told) const {
  const auto progress = [&](double part) {
    if (told) told(part);
  };
  std::vector<Json> kinds;
  for (const SceneTally& one : without_empty(
           tally(audit_scenes_from(blocks_.first(block), blocks_.size(block), seed_, progress, solvers_))))
    kinds.push_back(scene_tally_found(one));
  return kinds;
}

void ScenesWork::add(std::size_t /*block*/, const Json& found) {
  std::vector<SceneTally> kinds;
  for (const Json& kind : found.items()) kinds.push_back(scene_tally_of(kind));
  for (const SceneTally& kind : kinds) tallies_[kind.worst.index % tallies_.size()].add(kind);
}

}  // namespace nipref::verify
