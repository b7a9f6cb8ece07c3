#include <fmt/format.h>

#include <utility>

#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/select_by_id.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/seeds/errata.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

using SettledErratum = std::pair<FormulaErratum, Settlement>;

Json erratum_json(const SettledErratum& one) {
  const auto& [erratum, settlement] = one;
  return {{"id", erratum.id},
          {"seed", erratum.seed},
          {"equation", erratum.equation},
          {"printed", erratum.printed},
          {"right", erratum.right},
          {"proof", erratum.proof},
          {"at", settlement.at},
          {"printed_value", settlement.printed ? Json(*settlement.printed) : Json()},
          {"right_value", settlement.right},
          {"truth", settlement.truth},
          {"allowed", settlement.allowed},
          {"settled", settlement.settled()}};
}

std::string erratum_text(const SettledErratum& one) {
  const auto& [erratum, settlement] = one;
  return fmt::format(
      "{}, {} {}\n  printed: {}\n  right:   {}\n  {}: {}\n    printed {}, right {:.12g}, truth {:.12g} by {}\n",
      erratum.id, erratum.seed, erratum.equation, erratum.printed, erratum.right,
      verdict(settlement.settled(), settlement.settled() ? "settled" : "NOT SETTLED"), settlement.at,
      settlement.printed ? fmt::format("{:.12g}", *settlement.printed) : "no number", settlement.right,
      settlement.truth, erratum.proof);
}

}  // namespace

int errata_verb(const CommandLine& line, std::ostream& out) {
  std::vector<FormulaErratum> errata = formula_errata();
  select_by_id(errata, line.words, "erratum", &FormulaErratum::id);
  std::vector<SettledErratum> all;
  for (FormulaErratum& erratum : errata) {
    const Settlement settlement = settle(erratum);
    all.emplace_back(std::move(erratum), settlement);
  }
  const auto open = std::ranges::count_if(all, [](const auto& one) { return !one.second.settled(); });
  if (line.json) {
    out << answer_text("errata", {{"errata", json_list(all, erratum_json)}}, line.no_times);
  } else {
    std::string text = fmt::format("{} errata of formulas, {} not settled; those of tables: nipref tables\n",
                                   all.size(), open);
    for (const SettledErratum& one : all) text += "\n" + erratum_text(one);
    out << folded(text);
  }
  return open == 0 ? 0 : 1;
}

}  // namespace nipref::verify
