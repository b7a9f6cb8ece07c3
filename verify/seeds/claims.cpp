#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include <nipref/data/directory.hpp>
#include <nipref/verify/seeds/claims.hpp>
#include <nipref/verify/seeds/internal/statement.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

constexpr std::array<std::pair<ClaimVerdict, std::string_view>, 3> verdicts{
    {{ClaimVerdict::holds, "holds"},
     {ClaimVerdict::fails, "false"},
     {ClaimVerdict::holds_in_a_range, "holds in a range"}}};

/// `text` with the values of the names in it, {NAME:FORMAT}.
std::string filled(const std::string& text, StatementFormulas& formulas) {
  std::string all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = std::min(text.find('{', at), text.size()), close = text.find('}', open);
    all += text.substr(at, open - at);
    if (open == text.size()) break;
    const std::string field = text.substr(open + 1, close - open - 1);
    const std::size_t colon = field.find(':');
    all += fmt::format(fmt::runtime("{:" + field.substr(colon + 1) + "}"),
                       formulas.value(field.substr(0, colon)).value());
    at = close + 1;
  }
  return all;
}

const Statement& claims_file() {
  static const Statement file = read_statements(data::statements_directory() / "claims.toml");
  return file;
}

}  // namespace

std::string_view name_of(ClaimVerdict verdict) {
  return std::ranges::find(verdicts, verdict, [](const auto& one) { return one.first; })->second;
}

std::string_view ClaimNumber::origin() const {
  if (is_printed) return "printed";
  return number.error() == 0 ? "exact" : "computed";
}

std::vector<Claim> claims() {
  std::vector<Claim> all;
  for (const Statement& one : claims_file().list("claim", {"id", "seed", "place", "statement"},
                                                 {"setting", "given", "number", "verdict"}))
    all.push_back({one.text("id"), one.text("seed"), one.text("place"), one.text("statement")});
  return all;
}

ClaimOutcome check(const Claim& claim) {
  const Statement& entry = claims_file().entry("claim", claim.id);
  StatementFormulas formulas(claims_file(), entry);
  ClaimOutcome outcome{ClaimVerdict::holds, "", {}};
  for (const Statement& one : entry.list("number", {"what", "is"}, {"name", "origin"})) {
    const Propagated number = formulas.value(one.text("is"));
    if (const std::string name = one.text_or("name", ""); !name.empty()) formulas.define(name, number);
    outcome.numbers.push_back({one.text("what"), number, one.text_or("origin", "") == "printed"});
  }
  for (const Statement& one : entry.list("verdict", {"is"}, {"if", "why"})) {
    const std::string condition = one.text_or("if", "");
    if (!condition.empty() && !formulas.is_true(condition)) continue;
    const auto verdict =
        std::ranges::find(verdicts, one.text("is"), [](const auto& known) { return known.second; });
    if (verdict == verdicts.end()) one.refuse("must be holds, false or holds in a range");
    outcome.verdict = verdict->first;
    outcome.why = filled(one.text_or("why", ""), formulas);
    return outcome;
  }
  entry.refuse("must have a [[claim.verdict]] whose condition is fulfilled");
}

std::vector<CheckedClaim> check_all(std::vector<Claim> claims) {
  std::vector<CheckedClaim> checked;
  for (Claim& claim : claims) checked.push_back({std::move(claim), {}});
  parallel_for(checked.size(), [&](std::size_t i) { checked[i].outcome = check(checked[i].claim); }, {});
  return checked;
}

}  // namespace nipref::verify
