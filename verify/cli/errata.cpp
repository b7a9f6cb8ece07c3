#include <fmt/format.h>

#include <utility>

#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/select_by_id.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/seeds/errata.hpp>
#include <nipref/verify/seeds/render.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
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
