#pragma once
#include <string>
#include <vector>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// " name=value (decimal)" for each argument: for people, and for `eval` up to what stands in brackets.
std::string point_text(const Quantity& quantity, const Point& point);
Json point_json(const Quantity& quantity, const Point& point);

Json audit_row_json(const AuditResult& result);
/// The "rows" of an audit.
Json audit_json(const std::vector<AuditResult>& results);

/// True if every promise was kept.
bool all_kept(const std::vector<AuditResult>& results);

}  // namespace nipref::verify
