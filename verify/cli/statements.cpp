#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/seeds/statements.hpp>
#include <nipref/verify/support/text.hpp>

// What the seeds say in words, formulas and figures.

namespace nipref::verify {

VerbAnswer claims_verb(const CommandLine& line) {
  std::vector<Statement> selected = claims();
  select_by_id(selected, line.words, "claim", &Statement::id);
  const std::vector<CheckedClaim> checked = check_all(selected);
  const Json counts = verdict_counts_json(
      checked, {ClaimVerdict::holds, ClaimVerdict::holds_in_a_range, ClaimVerdict::fails});
  return {"claims", {{"claims", claims_json(checked)}, {"_verdicts", counts}}};
}

VerbAnswer limits_verb(const CommandLine& line) {
  std::vector<Statement> selected = limits();
  select_by_id(selected, line.words, "limit", &Statement::id);
  const std::vector<LimitRow> rows = approach_all(selected);
  const auto missed = std::ranges::count_if(rows, [](const LimitRow& row) { return !row.approached(); });
  return {"limits", {{"rows", limits_json(rows)}, {"_of", rows.size()}, {"_missed", missed}}, missed == 0};
}

VerbAnswer errata_verb(const CommandLine& line) {
  std::vector<Statement> errata = formula_errata();
  select_by_id(errata, line.words, "erratum", &Statement::id);
  const std::vector<Settlement> all = settle_all(errata);
  const auto open = std::ranges::count_if(all, std::not_fn(&Settlement::settled));
  return {"errata", {{"errata", errata_json(all)}, {"_of", all.size()}, {"_open", open}}, open == 0};
}

namespace {

Json plan_json(const FigurePlan& plan) {
  return {{"id", plan.id}, {"title", plan.title}, {"parameters", plan.parameters}};
}

std::string figure_svg(const Figure& figure, const std::string& file) {
  const auto drawn = drawn_by_gnuplot(gnuplot_script(figure_json(figure)));
  if (!drawn)
    throw data::BadInput("svg", file,
                         "must wait for the program gnuplot, which is not installed (Debian's gnuplot-nox)");
  return *drawn;
}

}  // namespace

VerbAnswer figures_verb(const CommandLine& line) {
  std::vector<FigurePlan> plans = figures();
  select_by_id(plans, line.words, "figure", &FigurePlan::id);
  const auto csv = line.option("csv"), svg = line.option("svg");
  if (line.has("list"))
    return {"figures", {{"figures", json_list(plans, plan_json)}}, true, "figures_list.txt"};
  if (line.words.empty())
    throw data::BadInput("figure", "(missing)", "must be one of those that --list shows");
  if (plans.size() > 1) throw data::BadInput("figure", line.words[1], "must be the only one");
  const Figure figure = compute(plans.front());
  const std::string drawing = svg ? figure_svg(figure, *svg) : "";
  if (csv) write_output_file(*csv, figure_csv(figure));
  if (svg) write_output_file(*svg, drawing);
  const Json json = figure_json(figure);
  if (csv || svg)
    return {"figures", {{"figure", json}}, true, [=] { return folded(text_of("figure.txt", json)); }};
  return {"figures", {{"figure", json}}, true, [=] { return figure_csv(figure); }};
}

}  // namespace nipref::verify
