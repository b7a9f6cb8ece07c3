#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/seeds/statements.hpp>
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

namespace {

std::string order_text(const LimitRow& row) {
  return row.order == 0 ? "faster than any power" : fmt::format("with its power {:g}", row.order);
}

std::string row_text(const LimitRow& row) {
  std::string text = fmt::format("{}: {}\n  {}\n", row.name, row.statement, row.source);
  for (const LimitSample& sample : row.samples)
    text += fmt::format("  {} = {:g}: {}, limit {}, distance {:.1e}\n", row.size, sample.size,
                        stated_text(sample.found), stated_text(sample.limit), sample.distance().value());
  const auto measured = row.measured_order();
  return text + fmt::format("  {}: the distance must fall {}, and {}\n",
                            verdict(row.approached(), row.approached() ? "approached" : "MISSED"),
                            order_text(row),
                            measured ? "falls with " + stated_text(*measured)
                                     : "is below the solver's error at last");
}

}  // namespace

int limits_verb(const CommandLine& line, std::ostream& out) {
  std::vector<LimitRow> rows = limits();
  select_by_id(rows, line.words, "limit", &LimitRow::name);
  const auto missed = std::ranges::count_if(rows, [](const LimitRow& row) { return !row.approached(); });
  if (line.json) {
    out << answer_text("limits", {{"rows", limits_json(rows)}}, line.no_times);
  } else {
    std::string text = fmt::format("{} limits, {} missed\n", rows.size(), missed);
    for (const LimitRow& row : rows) text += "\n" + row_text(row);
    out << folded(text);
  }
  return missed == 0 ? 0 : 1;
}

namespace {

std::string erratum_text(const SettledErratum& one) {
  const auto& [erratum, settlement] = one;
  return fmt::format(
      "{}, {} {}\n  printed: {}\n  right:   {}\n  {}: {}\n    printed {}, right {}, truth {} by {}\n",
      erratum.id, erratum.seed, erratum.equation, erratum.printed, erratum.right,
      verdict(settlement.settled(), settlement.settled() ? "settled" : "NOT SETTLED"), settlement.at,
      settlement.printed ? stated_text(*settlement.printed) : "no number", stated_text(settlement.right),
      stated_text(settlement.truth), erratum.proof);
}

}  // namespace

int errata_verb(const CommandLine& line, std::ostream& out) {
  std::vector<FormulaErratum> errata = formula_errata();
  select_by_id(errata, line.words, "erratum", &FormulaErratum::id);
  const std::vector<SettledErratum> all = settle_all(std::move(errata));
  const auto open = std::ranges::count_if(all, [](const auto& one) { return !one.settlement.settled(); });
  if (line.json) {
    out << answer_text("errata", {{"errata", errata_json(all)}}, line.no_times);
  } else {
    std::string text = fmt::format("{} errata of formulas, {} not settled; those of tables: nipref tables\n",
                                   all.size(), open);
    for (const SettledErratum& one : all) text += "\n" + erratum_text(one);
    out << folded(text);
  }
  return open == 0 ? 0 : 1;
}

}  // namespace nipref::verify
