#include <fmt/format.h>

#include <utility>

#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>
#include <nipref/verify/support/mapped.hpp>

namespace nipref::verify {
namespace {

Json json_of(const QuantityFindings& found) { return found.tally.json(); }
Json json_of(const std::vector<ContactAudit>& found) { return json_list(found, contact_audit_found); }
Json json_of(const std::vector<SceneTally>& found) { return json_list(found, scene_tally_found); }

}  // namespace

Json block_findings_json(const BlockFindings& found) {
  return std::visit([](const auto& of_work) { return json_of(of_work); }, found);
}

QuantityWork::QuantityWork(const Quantity& quantity, AuditOptions options, bool keeps_points)
    : QuantityWork(quantity, options, fast_evaluator(quantity, options.accuracy), true, keeps_points) {}

QuantityWork::QuantityWork(const Quantity& quantity, AuditOptions options, Evaluator evaluator, bool is_fast,
                           bool keeps_points)
    : quantity_(quantity),
      options_(std::move(options)),
      evaluator_(std::move(evaluator)),
      comparator_(quantity, evaluator_, options_, is_fast),
      keeps_points_(keeps_points) {}

const AuditPlan& QuantityWork::plan() const {
  if (!plan_) plan_ = std::make_unique<AuditPlan>(quantity_, options_);
  return *plan_;
}

BlockFindings QuantityWork::found_in(std::size_t block, const OnProgress& on_progress) const {
  QuantityFindings found = audit_block(quantity_, options_.ranges, comparator_, plan(), block, on_progress);
  if (!keeps_points_) found.compared = {};
  return found;
}

BlockFindings QuantityWork::read_findings(const Json& json) const {
  return QuantityFindings{AuditTally::of(json, quantity_.arguments.size()), {}};
}

void QuantityWork::add(std::size_t block, const BlockFindings& found) {
  sum_.add(std::get<QuantityFindings>(found), block);
}

AuditResult QuantityWork::result() const {
  AuditResult result = result_of(quantity_, options_, sum_.tally, plan().points(0).front());
  if (keeps_points_) add_places(result.spread, quantity_, sum_.compared.points, sum_.compared.findings);
  return result;
}

BlockFindings HardCasesWork::found_in(std::size_t block, const OnProgress& /*on_progress*/) const {
  stop_if_interrupted();
  return audit_hard_cases(block);
}

BlockFindings HardCasesWork::read_findings(const Json& json) const {
  return mapped(json.items(), contact_audit_of);
}

void HardCasesWork::add(std::size_t block, const BlockFindings& found) {
  audits_.emplace(block, std::get<std::vector<ContactAudit>>(found));
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

BlockFindings ScenesWork::found_in(std::size_t block, const OnProgress& on_progress) const {
  return without_empty(
      tally(audit_scenes(blocks_.first(block), blocks_.size(block), seed_, on_progress, solvers_)));
}

BlockFindings ScenesWork::read_findings(const Json& json) const {
  return mapped(json.items(), scene_tally_of);
}

void ScenesWork::add(std::size_t /*block*/, const BlockFindings& found) {
  for (const SceneTally& kind : std::get<std::vector<SceneTally>>(found))
    tallies_[kind.worst.index % tallies_.size()].add(kind);
}

}  // namespace nipref::verify
