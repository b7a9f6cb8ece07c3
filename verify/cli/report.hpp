#pragma once
#include <vector>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/cli/audit_all.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/json.hpp>
#include <nipref/verify/witness/witness.hpp>

namespace nipref::verify {

/// What `report` answers: what its parts would.
Json report_json(const BenchReport& speed, const std::vector<AuditResult>& quantities,
                 const ContactAudits& contacts, const Witness& witness, const std::vector<Replay>& tables);

}  // namespace nipref::verify
