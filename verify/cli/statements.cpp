#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/programs.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/seeds/statements.hpp>
#include <nipref/verify/support/text.hpp>

// What the seeds say in words, formulas and figures.

namespace nipref::verify {

namespace {

/// The heading, and a paragraph for each row.
template <class Row>
std::string paragraphs(std::string heading, const std::vector<Row>& rows,
                       std::string (*text_of)(const Row&)) {
  for (const Row& row : rows) heading += "\n" + text_of(row);
  return folded(heading);
}

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

std::string verdicts_text(const std::vector<CheckedClaim>& claims) {
  std::string text;
  for (const ClaimVerdict verdict :
       {ClaimVerdict::holds, ClaimVerdict::holds_in_a_range, ClaimVerdict::fails})
    text += fmt::format("{}: {}\n", name_of(verdict), std::ranges::count_if(claims, [&](const auto& one) {
                          return one.outcome.verdict == verdict;
                        }));
  return text;
}

std::string limit_text(const LimitRow& row) {
  std::string text = fmt::format("{}: {}\n  {}\n", row.name, row.statement, row.source);
  for (const LimitSample& sample : row.samples)
    text += fmt::format("  {} = {:g}: {}, limit {}, distance {:.1e}\n", row.size, sample.size,
                        stated_text(sample.found), stated_text(sample.limit), sample.distance().value());
  const auto measured = row.measured_order();
  return text +
         fmt::format(
             "  {}: the distance must fall {}, and {}\n",
             verdict(row.approached(), row.approached() ? "approached" : "MISSED"),
             row.order == 0 ? "faster than any power" : fmt::format("with its power {:g}", row.order),
             measured ? "falls with " + stated_text(*measured) : "is below the solver's error at last");
}

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

int claims_verb(const CommandLine& line, std::ostream& out) {
  std::vector<Claim> selected = claims();
  select_by_id(selected, line.words, "claim", &Claim::id);
  const std::vector<CheckedClaim> checked = check_all(std::move(selected));
  return write_answer(
      line, out, "claims", true,
      [&] {
        return Json{{"claims", claims_json(checked)}};
      },
      [&] { return paragraphs(verdicts_text(checked), checked, claim_text); });
}

int limits_verb(const CommandLine& line, std::ostream& out) {
  std::vector<LimitRow> rows = limits();
  select_by_id(rows, line.words, "limit", &LimitRow::name);
  const auto missed = std::ranges::count_if(rows, [](const LimitRow& row) { return !row.approached(); });
  return write_answer(
      line, out, "limits", missed == 0,
      [&] {
        return Json{{"rows", limits_json(rows)}};
      },
      [&] {
        return paragraphs(fmt::format("{} limits, {} missed\n", rows.size(), missed), rows, limit_text);
      });
}

int errata_verb(const CommandLine& line, std::ostream& out) {
  std::vector<FormulaErratum> errata = formula_errata();
  select_by_id(errata, line.words, "erratum", &FormulaErratum::id);
  const std::vector<SettledErratum> all = settle_all(std::move(errata));
  const auto open = std::ranges::count_if(all, [](const auto& one) { return !one.settlement.settled(); });
  const std::string heading = fmt::format(
      "{} errata of formulas, {} not settled; those of tables: nipref tables\n", all.size(), open);
  return write_answer(
      line, out, "errata", open == 0,
      [&] {
        return Json{{"errata", errata_json(all)}};
      },
      [&] { return paragraphs(heading, all, erratum_text); });
}

namespace {

Json plan_json(const FigurePlan& plan) {
  return {{"id", plan.id}, {"title", plan.title}, {"parameters", plan.parameters}};
}

std::string plans_text(const std::vector<FigurePlan>& plans) {
  std::string text;
  for (const FigurePlan& plan : plans)
    text += fmt::format("{:<18} {}\n{:20}{}\n", plan.id, plan.title, "", plan.parameters);
  return folded(text);
}

std::string figure_svg(const Figure& figure, const std::string& file) {
  const auto drawn = drawn_by_gnuplot(gnuplot_script(figure_json(figure)));
  if (!drawn)
    throw data::BadInput("svg", file,
                         "must wait for the program gnuplot, which is not installed (Debian's gnuplot-nox)");
  return *drawn;
}

}  // namespace

int figures_verb(const CommandLine& line, std::ostream& out) {
  std::vector<FigurePlan> plans = figures();
  select_by_id(plans, line.words, "figure", &FigurePlan::id);
  const auto csv = line.option("csv"), svg = line.option("svg");
  if (line.has("list")) {
    return write_answer(
        line, out, "figures", true,
        [&] {
          return Json{{"figures", json_list(plans, plan_json)}};
        },
        [&] { return plans_text(plans); });
  }
  if (line.words.empty())
    throw data::BadInput("figure", "(missing)", "must be one of those that --list shows");
  if (plans.size() > 1) throw data::BadInput("figure", line.words[1], "must be the only one");
  const Figure figure = compute(plans.front());
  const std::string drawing = svg ? figure_svg(figure, *svg) : "";
  if (csv) write_output_file(*csv, figure_csv(figure));
  if (svg) write_output_file(*svg, drawing);
  return write_answer(
      line, out, "figures", true,
      [&] {
        return Json{{"figure", figure_json(figure)}};
      },
      [&] { return csv || svg ? folded(figure_text(figure)) : figure_csv(figure); });
}

}  // namespace nipref::verify
