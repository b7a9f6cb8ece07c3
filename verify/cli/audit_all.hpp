#pragma once
#include <vector>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/audit/internal/contacts.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/support/internal/progress.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// How many points and which accuracy the command line asks for: --points, or one of --density, --quick and
/// --thorough, and --rtol. BadInput for what is out of its domain, and for two of the first four.
AuditOptions audit_options(const CommandLine& line);

/// Audits one quantity after the other. Those that are finished, if the process is interrupted.
std::vector<AuditResult> audit_all(const std::vector<const Quantity*>& quantities, AuditOptions options,
                                   Progress& progress);

/// What `audit` answers, and what stands for it in a report.
Json audits_json(const std::vector<AuditResult>& results, const std::vector<ContactAudit>& contacts,
                 fast::Accuracy accuracy);

}  // namespace nipref::verify
