#include <nipref/data/directory.hpp>
#include <nipref/verify/cli/report_parts.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/seeds/statements.hpp>
#include <nipref/verify/support/text.hpp>

// The verbs about what the seeds say in words, formulas, figures and tables.

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

namespace {

VerbAnswer list_tables(const std::vector<std::string>& ids) {
  std::vector<data::TableSummary> summaries;
  if (ids.empty()) summaries = data::summarize_tables();
  for (const std::string& id : ids) summaries.push_back(data::summarize(data::load_table_by_id(id)));
  return {"tables", table_list_json(summaries), true, "tables_list.txt"};
}

/// Whether a cell is unexplained although its table does not contradict the printed number, and is not a known miss.
bool falls_short(const std::vector<data::KnownMiss>& known, const Replay& replay, const ReplayedCell& cell) {
  const data::TableCell& printed = replay.table.cell(cell.row, cell.column);
  return cell.verdict == Verdict::unexplained && printed.is_readable() && !printed.is_doubtful() &&
         !is_known_miss(known, replay, cell);
}

}  // namespace

std::vector<Replay> replay_and_correct(const std::vector<std::string>& ids, Progress& progress) {
  std::vector<Replay> replays;
  progress.each("tables", ids, std::identity(), [&](const std::string& id) {
    Replay replay = replay_table(id);
    correct(replay);
    replays.push_back(std::move(replay));
  });
  return replays;
}

bool fall_short(const std::vector<Replay>& replays) {
  const auto known = data::load_known_misses(data::tables_directory() / "known_misses.csv");
  return std::ranges::any_of(replays, [&](const Replay& replay) {
    return std::ranges::any_of(replay.cells,
                               [&](const ReplayedCell& cell) { return falls_short(known, replay, cell); });
  });
}

VerbAnswer tables_verb(const CommandLine& line) {
  const std::vector<std::string> ids =
      each_once(mapped(line.words, [](const auto& name) { return data::find_table_id(name); }));
  if (line.has("list")) return list_tables(ids);
  Progress progress(line.has("quiet"));
  const auto replays = replay_and_correct(ids.empty() ? replayable_tables() : ids, progress);
  return {"tables", tables_json(replays, line.has("full")), !fall_short(replays)};
}

}  // namespace nipref::verify
