#pragma once
#include <vector>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/audit/internal/contacts.hpp>
#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// What `report` answers: what its parts would.
Json report_json(const BenchReport& speed, const std::vector<AuditResult>& quantities,
                 const std::vector<ContactAudit>& contacts, const std::vector<Replay>& tables);

}  // namespace nipref::verify
