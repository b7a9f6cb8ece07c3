#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/select_by_id.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/seeds/claims.hpp>
#include <nipref/verify/seeds/render.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

std::string claim_text(const CheckedClaim& checked) {
  const auto& [claim, outcome] = checked;
  std::string text = fmt::format("{}: {}, {} {}\n  {}\n",
                                 verdict(outcome.verdict != ClaimVerdict::fails, name_of(outcome.verdict)),
                                 claim.id, claim.seed, claim.place, claim.statement);
  if (!outcome.why.empty()) text += "  " + outcome.why + "\n";
  for (const ClaimNumber& one : outcome.numbers) {
    const std::string number = stated_text(one.number);
    text += fmt::format("    {:<28} {}\n",
                        one.number.error() == 0 && !one.is_printed ? number + ", exactly" : number, one.what);
  }
  return text;
}

}  // namespace

int claims_verb(const CommandLine& line, std::ostream& out) {
  std::vector<Claim> selected = claims();
  select_by_id(selected, line.words, "claim", &Claim::id);
  const std::vector<CheckedClaim> checked = check_all(std::move(selected));
  if (line.json) {
    out << answer_text("claims", {{"claims", claims_json(checked)}}, line.no_times);
    return 0;
  }
  std::string text;
  for (const ClaimVerdict verdict :
       {ClaimVerdict::holds, ClaimVerdict::holds_in_a_range, ClaimVerdict::fails})
    text += fmt::format("{}: {}\n", name_of(verdict), std::ranges::count_if(checked, [&](const auto& one) {
                          return one.outcome.verdict == verdict;
                        }));
  for (const CheckedClaim& one : checked) text += "\n" + claim_text(one);
  out << folded(text);
  return 0;
}

}  // namespace nipref::verify
