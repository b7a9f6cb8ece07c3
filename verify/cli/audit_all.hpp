#pragma once
#include <vector>

#include <nipref/verify/audit/audit.hpp>

namespace nipref::verify {

/// Audits one quantity after the other, with progress on standard error if that is a terminal.
std::vector<AuditResult> audit_all(const std::vector<const Quantity*>& quantities, AuditOptions options);

}  // namespace nipref::verify
