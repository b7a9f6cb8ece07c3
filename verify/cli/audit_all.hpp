#pragma once
#include <string>
#include <vector>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/audit/internal/contacts.hpp>
#include <nipref/verify/audit/internal/scene_tally.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/support/internal/progress.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// How many points, drawn from what, and which accuracy the command line asks for: --points, or one of --density, --quick
/// and --thorough, --seed and --rtol. BadInput for what is out of its domain, and for two of the first four.
AuditOptions audit_options(const CommandLine& line);

/// Audits one quantity after the other, in these ranges of its arguments (see ranges.hpp). Those that are finished, if the
/// process is interrupted.
std::vector<AuditResult> audit_all(const std::vector<const Quantity*>& quantities, AuditOptions options,
                                   Progress& progress, const Assignments& ranges = {});

/// Of whole contacts: hard cases, and random scenes.
struct ContactAudits {
  std::vector<ContactAudit> hard_cases;
  std::vector<SceneTally> scenes;

  [[nodiscard]] bool kept() const { return all_kept(hard_cases) && all_kept(scenes); }
};

/// How many scenes of which seed the command line asks for, and the hard cases; what is finished, if the
/// process is interrupted. Two items of the progress.
ContactAudits audit_all_contacts(const CommandLine& line, Progress& progress);

std::string contact_audits_text(const ContactAudits& contacts);

/// What `audit` answers, and what stands for it in a report.
Json audits_json(const std::vector<AuditResult>& results, const ContactAudits& contacts,
                 fast::Accuracy accuracy);

}  // namespace nipref::verify
