#pragma once
#include <vector>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/audit/internal/contacts.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// Audits one quantity after the other, with progress on standard error if that is a terminal.
std::vector<AuditResult> audit_all(const std::vector<const Quantity*>& quantities, AuditOptions options);

/// What `audit` answers, and what stands for it in a report.
Json audits_json(const std::vector<AuditResult>& results, const std::vector<ContactAudit>& contacts,
                 fast::Accuracy accuracy);

}  // namespace nipref::verify
