#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/seeds/propagated.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// A number that decides about a claim.
struct ClaimNumber {
  std::string what;
  Propagated number;
  bool is_printed = false;  ///< by the seed

  /// "printed", "exact", "computed"
  [[nodiscard]] std::string_view origin() const;
};

enum class ClaimVerdict { holds, fails, holds_in_a_range };

/// "holds", "false", "holds in a range"
std::string_view name_of(ClaimVerdict verdict);

/// What came of checking a claim: the verdict follows from the numbers.
struct ClaimOutcome {
  ClaimVerdict verdict;
  std::string why;  ///< one sentence with the numbers that decide, or the range in which it holds
  std::vector<ClaimNumber> numbers;
};

/// Something that a seed says in words, of data/statements/claims.csv.
struct Claim {
  std::string id;         ///< "thesis-creep-with-friction"
  std::string seed;       ///< thesis, brock2012 or brock2013
  std::string place;      ///< "(5.14)"
  std::string statement;  ///< what it says, in our words
};

/// All of data/statements/claims.csv. BadInput that names its line if it cannot be read or names a claim that nothing checks.
std::vector<Claim> claims();

/// Checks it, now. The claim is one of claims().
ClaimOutcome check(const Claim& claim);

struct CheckedClaim {
  Claim claim;
  ClaimOutcome outcome;
};

/// The same of many, on all cores, in their order.
std::vector<CheckedClaim> check_all(std::vector<Claim> claims);

/// What `claims` answers, and a report has of them.
Json claims_json(const std::vector<CheckedClaim>& claims);

}  // namespace nipref::verify
