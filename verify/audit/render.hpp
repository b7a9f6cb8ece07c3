#pragma once
#include <string>
#include <vector>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// Table for people, one line a quantity; the verdict is "kept, few" where few points found it kept.
std::string audit_text(const std::vector<AuditResult>& results, fast::Accuracy accuracy);

/// The "rows" of an audit.
Json audit_json(const std::vector<AuditResult>& results);

/// True if every promise was kept.
bool all_kept(const std::vector<AuditResult>& results);

}  // namespace nipref::verify
