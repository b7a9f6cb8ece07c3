#include <nipref/data/directory.hpp>
#include <nipref/data/table/csv.hpp>
#include <nipref/verify/figures/internal/drawings.hpp>
#include <nipref/verify/support/internal/cache.hpp>
#include <nipref/verify/support/internal/parallel.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

using Curves = std::vector<Series>;

std::vector<double> evenly(double first, double last, int count) {
  return mapped(std::views::iota(0, count), [&](int i) { return std::lerp(first, last, i / (count - 1.0)); });
}

/// The scope with the definitions of a table of the file as the innermost ones.
FigureScope within(FigureScope scope, const TomlTable& table) {
  scope.given.push_back(table.text_or("given", ""));
  return scope;
}

/// The scopes of all rounds of these nested loops.
std::vector<FigureScope> rounds_of(const FigureScope& outer, const std::string& loops) {
  std::vector<FigureScope> all{outer};
  for (const std::string& loop : words_of(loops)) {
    std::vector<FigureScope> longer;
    for (const FigureScope& scope : all) {
      for (const std::string& name : loop == "of" ? scope.row->of : std::vector<std::string>()) {
        const TomlTable& shown = drawings_file().entry("shown", name);
        longer.push_back(within(scope, shown));
        longer.back().shown = &shown;
      }
      for (const Replay& table :
           loop == "tables" ? std::span(scope.row->tables) : std::span<const Replay>()) {
        longer.push_back(scope);
        longer.back().table = &table;
      }
      for (const double number : scope.row->numbers(loop)) {
        longer.push_back(scope);
        longer.back().numbers.emplace_back(loop, number);
      }
    }
    all = std::move(longer);
  }
  return all;
}

/// The replayed cells of a curve, if the curve has a role, and the printed cells that are legible and not doubtful.
Curves cells_of(const TomlTable& curve, const std::string& label, FigureFormulas& formulas) {
  const std::string column = formulas.text(curve.text("cells")), role = curve.text_or("role", ""),
                    at = curve.text("at"), printed_at = curve.text_or("printed_at", at);
  Series replayed{label, role, Mark::points, {}, {}}, printed{label, "printed", Mark::bars, {}, {}};
  for (const Replay& replay : formulas.tables()) {
    for (const ReplayedCell& cell : replay.cells) {
      if (!column.empty() && cell.column != column) continue;
      formulas.enter(replay, cell);
      if (formulas.value(curve.text_or("if", "1")) == 0) continue;
      replayed.x.push_back(formulas.value(at));
      replayed.y.push_back(cell.value);
      const data::TableCell& text = replay.table.cell(cell.row, cell.column);
      if (!text.is_printed() || !text.is_readable() || text.is_doubtful()) continue;
      printed.x.push_back(formulas.value(printed_at));
      printed.y.push_back(text.number->value);
      printed.low.push_back(text.number->rounding.lower);
      printed.high.push_back(text.number->rounding.upper);
    }
  }
  return role.empty() ? Curves{printed} : Curves{replayed, printed};
}

Curves curves_of(const TomlTable& curve, const std::string& label, const FigureScope& scope,
                 FigureContacts& contacts) {
  FigureFormulas formulas(scope, contacts);
  if (curve.texts.contains("cells")) return cells_of(curve, formulas.text(label), formulas);
  const auto mark = mark_named(curve.text("mark"));
  if (!mark) curve.refuse("must have a mark that figures have");
  Series series{formulas.text(label), curve.text("role"), *mark, {}, {}};
  static const std::map<std::string, DrawnSeries*> others{
      {"line loads", by_line_loads}, {"creep ranges", creep_ranges}, {"slip zones", slip_zones}};
  if (const auto other = others.find(curve.text_or("by", "")); other != others.end())
    return other->second(formulas, series);
  const std::string along = curve.text_or("along", "");
  if (!along.empty() && !scope.row->lists.contains(along))
    curve.refuse(fmt::format("must have a figure with numbers for '{}'", along));
  for (const double number : along.empty() ? std::vector{0.0} : scope.row->numbers(along)) {
    formulas.define(along, number);
    series.x.push_back(formulas.value(curve.text_or("x", along)));
    series.y.push_back(formulas.value(curve.text("y")));
  }
  return {series};
}

/// All curves of one round of a group. They share their contacts.
Curves curves_of_group(const TomlTable& group, const FigureScope& scope) {
  FigureContacts contacts;
  Curves all;
  for (const TomlTable& curve : group.list("curve", {},
                                           {"each", "only", "label", "role", "mark", "along", "x", "y", "by",
                                            "cells", "if", "at", "printed_at"})) {
    const std::string only = curve.text_or("only", ""),
                      label = curve.text_or("label", group.text_or("label", ""));
    if (!only.empty() && only != scope.shown->text("id")) continue;
    for (const FigureScope& round : rounds_of(scope, curve.text_or("each", "")))
      std::ranges::move(curves_of(curve, label, round, contacts), std::back_inserter(all));
  }
  return all;
}

/// A panel without its curves.
Panel panel_of(const TomlTable& stated, const FigureScope& scope, FigureContacts& contacts) {
  FigureFormulas formulas(scope, contacts);
  const TomlTable& axes = stated.table("axes");
  const auto axis = [&](const std::string& name) {
    return FigureAxis{formulas.text(axes.text(name)), formulas.value(axes.text_or("log_" + name, "0")) != 0};
  };
  Panel panel{axis("x"), axis("y"), {}, axes.number_or("equal_scales", 0) != 0};
  if (stated.number_or("contours", 0) != 0) panel.contours = stress_contours(formulas);
  return panel;
}

std::vector<Panel> panels_of(const FigureRow& row) {
  struct Round {
    std::size_t panel;
    const TomlTable* group;
    FigureScope scope;
  };
  FigureContacts contacts;
  std::vector<Panel> panels;
  std::vector<Round> rounds;
  for (const std::string& name : row.panels) {
    const TomlTable& stated = drawings_file().entry("panel", name);
    for (const FigureScope& scope :
         rounds_of({.row = &row, .given = {drawings_file().text("given")}}, stated.text_or("each", ""))) {
      panels.push_back(panel_of(stated, within(scope, stated), contacts));
      for (const TomlTable& group : stated.list("group", {}, {"each", "label", "given", "curve"})) {
        for (const FigureScope& round : rounds_of(within(scope, stated), group.text_or("each", "")))
          rounds.push_back({panels.size() - 1, &group, within(round, group)});
      }
    }
  }
  auto curves = parallel_mapped(
      rounds.size(), [&](std::size_t i) { return curves_of_group(*rounds[i].group, rounds[i].scope); });
  for (std::size_t i = 0; i < rounds.size(); ++i)
    std::ranges::move(curves[i], std::back_inserter(panels[rounds[i].panel].series));
  return panels;
}

FigureRow figure_row(const std::vector<data::CsvField>& record) {
  FigureRow row{parts_of(record[3].text, "; "), parts_of(record[4].text, "; "), record[5].text, {}, {}};
  for (const std::string& list : parts_of(record[6].text, ";")) {
    const auto parts = words_of(list);
    if (!parts.empty()) row.lists[parts.front()] = {parts.begin() + 1, parts.end()};
  }
  static Cache<std::string, Replay> known;
  row.tables = mapped(words_of(record[7].text),
                      [](const auto& id) { return *known.at(id, [&] { return replay_table(id); }); });
  return row;
}

}  // namespace

std::vector<double> FigureRow::numbers(const std::string& name) const {
  const auto found = lists.find(name);
  if (found == lists.end()) return {};
  const std::vector<std::string>& list = found->second;
  const auto number = [&](std::size_t i) { return std::stod(list.at(i)); };
  std::vector<double> all;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const bool has_ratios = list[i] == "ratios";
    if (list[i] == "without") {
      std::erase(all, number(++i));
    } else if (has_ratios || list[i] == "evenly") {
      const double first = number(i + 1), last = number(i + 2);
      const int count = std::stoi(list.at(i + 3));
      for (const double one :
           has_ratios ? evenly(std::log10(first), std::log10(last), count) : evenly(first, last, count))
        all.push_back(has_ratios ? std::pow(10, one) : one);
      i += 3;
    } else {
      all.push_back(number(i));
    }
  }
  return all;
}

std::vector<FigurePlan> figures() {
  const data::CsvFile file = data::read_csv(data::statements_directory() / "figures.csv");
  std::vector<FigurePlan> all;
  for (const auto& record : std::span(file.records).subspan(1)) {
    if (record.size() != 8)
      data::refuse(file.path, record.front().position,
                   "must have id, title, parameters, panels, of, label, numbers, tables");
    all.push_back(
        {record[0].text, record[1].text, record[2].text, [=] { return panels_of(figure_row(record)); }});
  }
  return all;
}

Figure compute(const FigurePlan& plan) { return {plan.id, plan.title, plan.parameters, plan.compute()}; }

}  // namespace nipref::verify
