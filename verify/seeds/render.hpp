#pragma once
#include <vector>

#include <nipref/verify/seeds/claims.hpp>
#include <nipref/verify/seeds/errata.hpp>
#include <nipref/verify/seeds/limits.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

// What `claims`, `limits` and `errata` answer, and what stands for it in a report: lists.

Json claims_json(const std::vector<CheckedClaim>& claims);
Json limits_json(const std::vector<LimitRow>& limits);
Json errata_json(const std::vector<SettledErratum>& errata);

}  // namespace nipref::verify
