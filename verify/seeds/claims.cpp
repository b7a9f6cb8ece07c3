#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/directory.hpp>
#include <nipref/data/table/csv.hpp>
#include <nipref/verify/seeds/claims.hpp>
#include <nipref/verify/seeds/internal/claim_checks.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

const ClaimChecks& checks() {
  static const ClaimChecks all = [] {
    ClaimChecks joined;
    for (auto* const part : {&friction_claims, &shear_claims, &rolling_claims, &half_space_claims})
      joined.merge(part());
    return joined;
  }();
  return all;
}

}  // namespace

std::string_view name_of(ClaimVerdict verdict) {
  switch (verdict) {
    case ClaimVerdict::holds:
      return "holds";
    case ClaimVerdict::fails:
      return "false";
    case ClaimVerdict::holds_in_a_range:
      break;
  }
  return "holds in a range";
}

std::string_view ClaimNumber::origin() const {
  if (is_printed) return "printed";
  return number.error() == 0 ? "exact" : "computed";
}

std::vector<Claim> claims() {
  const data::CsvFile file = data::read_csv(data::statements_directory() / "claims.csv");
  std::vector<Claim> all;
  for (std::size_t i = 1; i < file.records.size(); ++i) {
    const auto& record = file.records[i];
    if (record.size() != 4)
      data::refuse(file.path, record.front().position, "must have id, seed, place, statement");
    if (!checks().contains(record[0].text))
      data::refuse(file.path, record[0].position, "must be the id of a claim that is checked");
    all.push_back({record[0].text, record[1].text, record[2].text, record[3].text});
  }
  return all;
}

ClaimOutcome check(const Claim& claim) { return checks().at(claim.id)(); }

std::vector<CheckedClaim> check_all(std::vector<Claim> claims) {
  std::vector<CheckedClaim> checked;
  for (Claim& claim : claims) checked.push_back({std::move(claim), {}});
  parallel_for(checked.size(), [&](std::size_t i) { checked[i].outcome = check(checked[i].claim); }, {});
  return checked;
}

}  // namespace nipref::verify
