#pragma once
#include <functional>
#include <map>
#include <string_view>

#include <nipref/verify/seeds/claims.hpp>

namespace nipref::verify {

/// By the claim's id.
using ClaimChecks = std::map<std::string_view, std::function<ClaimOutcome()>>;

ClaimChecks friction_claims();
ClaimChecks shear_claims();
ClaimChecks rolling_claims();
ClaimChecks half_space_claims();

}  // namespace nipref::verify
