#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nipref/verify/replay/render.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

struct Counts {
  std::size_t cells = 0;  ///< all cells but the inputs
  std::size_t match = 0;
  std::size_t misprint = 0;
  std::size_t seed_error = 0;
  std::size_t unexplained = 0;
  std::size_t without_number = 0;  ///< unexplained cells whose print has no legible number
};

const data::TableCell& printed_cell(const Replay& replay, const ReplayedCell& cell) {
  return replay.table.cell(cell.row, cell.column);
}

bool is_without_number(const Replay& replay, const ReplayedCell& cell) {
  return cell.verdict == Verdict::unexplained && !printed_cell(replay, cell).is_readable();
}

Counts count(const std::vector<Replay>& replays) {
  Counts counts;
  for (const Replay& replay : replays) {
    counts.cells += replay.cells.size() - replay.count(Verdict::input);
    counts.match += replay.count(Verdict::match);
    counts.misprint += replay.count(Verdict::misprint);
    counts.seed_error += replay.count(Verdict::seed_error);
    counts.unexplained += replay.count(Verdict::unexplained);
    counts.without_number += static_cast<std::size_t>(std::ranges::count_if(
        replay.cells, [&](const ReplayedCell& cell) { return is_without_number(replay, cell); }));
  }
  return counts;
}

std::size_t decimals(const std::string& number) {
  const auto point = number.find('.');
  return point == std::string::npos ? 0 : number.size() - point - 1;
}

/// The number of decimals of the cell, or of the cell with the most decimals in its column if the cell is illegible.
std::size_t decimals_of(const Replay& replay, const ReplayedCell& cell) {
  const data::TableCell& printed = printed_cell(replay, cell);
  if (printed.is_readable()) return decimals(printed.read_as);
  const std::size_t column = replay.table.column_index(cell.column);
  std::size_t finest = 0;
  for (const auto& row : replay.table.rows) finest = std::max(finest, decimals(row[column].read_as));
  return finest;
}

/// The text of a value; nothing if there is no value.
std::optional<std::string> scaled(const Replay& replay, const ReplayedCell& cell,
                                  const std::optional<double>& value) {
  return value ? std::optional(scaled_text(replay, cell, *value)) : std::nullopt;
}

std::string row_label(const Replay& replay, std::size_t row) {
  std::string label;
  for (std::size_t i = 0; i < replay.table.columns.size(); ++i) {
    const data::TableColumn& column = replay.table.columns[i];
    if (column.is_key) label += fmt::format("{}={}", column.name, replay.table.rows[row][i].read_as);
  }
  return label;
}

std::string coloured(Verdict of_cell) {
  if (of_cell == Verdict::input) return std::string(name(of_cell));
  return verdict(of_cell == Verdict::match, name(of_cell));
}

void append_cells(std::string& text, const Replay& replay, bool all) {
  TextTable table({"  verdict", "row", "column", ">printed", ">replayed range", ">corrected"});
  for (const ReplayedCell& cell : replay.cells) {
    if (!all && (cell.verdict == Verdict::input || cell.verdict == Verdict::match)) continue;
    table.add({"  " + coloured(cell.verdict), row_label(replay, cell.row), cell.column,
               printed_cell(replay, cell).printed,
               fmt::format("{}..{}", scaled_text(replay, cell, cell.range.lower),
                           scaled_text(replay, cell, cell.range.upper)),
               scaled(replay, cell, cell.corrected).value_or("-")});
    if (!cell.note.empty()) table.add_below(cell.note);
  }
  if (!table.empty()) text += table.text();
}

/// Appends the errors that are due to the weaknesses of the seed's method.
void append_costs(std::string& text, const Replay& replay) {
  for (const Cost& cost : replay.costs) {
    fmt::format_to(std::back_inserter(text), "  {} ({}):", cost.weakness, cost.against);
    for (const ColumnDeviation& deviation : cost.columns) {
      fmt::format_to(std::back_inserter(text), " {} {:.3g} % in the mean, {:+.3g} % at most{}",
                     deviation.column, 100 * deviation.mean, 100 * deviation.largest,
                     &deviation == &cost.columns.back() ? "\n" : ";");
    }
  }
}

/// The same as a JSON number.
Json scaled_json(const Replay& replay, const ReplayedCell& cell, const std::optional<double>& value) {
  return value ? Json::number(scaled_text(replay, cell, *value)) : Json();
}

Json costs_json(const Replay& replay) {
  Json costs = Json::object();
  for (const Cost& cost : replay.costs) {
    Json columns = Json::object();
    for (const ColumnDeviation& deviation : cost.columns)
      columns.set(deviation.column, {{"mean", deviation.mean}, {"largest", deviation.largest}});
    costs.set(cost.weakness, columns);
  }
  return costs;
}

Json cell_json(const Replay& replay, const ReplayedCell& cell) {
  const data::TableCell& printed = printed_cell(replay, cell);
  Json row = Json::object();
  for (std::size_t i = 0; i < replay.table.columns.size(); ++i) {
    const data::TableColumn& column = replay.table.columns[i];
    if (column.is_key) row.set(column.name, replay.table.rows[cell.row][i].read_as);
  }
  return {{"row", row},
          {"column", cell.column},
          {"printed", Json::unless_empty(printed.printed)},
          {"read_as", printed.is_readable() ? Json(printed.read_as) : Json()},
          {"replayed", scaled_json(replay, cell, cell.value)},
          {"corrected", scaled_json(replay, cell, cell.corrected)},
          {"corrected_with_seed_material", scaled_json(replay, cell, cell.corrected_with_seed_material)},
          {"exact", scaled_json(replay, cell, cell.exact)},
          {"replayed_range", std::vector<Json>{scaled_json(replay, cell, cell.range.lower),
                                               scaled_json(replay, cell, cell.range.upper)}},
          {"verdict", name(cell.verdict)},
          {"note", Json::unless_empty(cell.note)}};
}

Json errata_json(const data::TableSummary& table) {
  Json errata = Json::object();
  for (std::size_t kind = 0; kind < table.errata.size(); ++kind)
    errata.set(data::erratum_kind_names[kind], table.errata[kind]);
  return errata;
}

Json table_json(const Replay& replay) {
  const auto to_json = [&](const ReplayedCell& cell) { return cell_json(replay, cell); };
  return {{"id", replay.table.id},
          {"title", replay.table.title},
          {"method", replay.method},
          {"costs", costs_json(replay)},
          {"cells", json_list(replay.cells, to_json)}};
}

}  // namespace

std::string scaled_text(const Replay& replay, const ReplayedCell& cell, double value) {
  const int exponent = replay.table.columns[replay.table.column_index(cell.column)].scale_exponent;
  return fmt::format("{:.{}f}", value * std::pow(10.0, exponent), decimals_of(replay, cell) + 2);
}

std::string tables_text(const std::vector<Replay>& replays, bool all_cells) {
  const Counts counts = count(replays);
  std::string text = fmt::format(
      "{} cells (inputs not counted): {} match, {} misprint, {} seed-error, {} unexplained, of which {} have no "
      "number\n",
      counts.cells, counts.match, counts.misprint, counts.seed_error, counts.unexplained,
      counts.without_number);
  for (const Replay& replay : replays) {
    fmt::format_to(std::back_inserter(text), "\n{}: {}\n  {} of {} cells match\n  {}\n", replay.table.id,
                   replay.table.title, replay.count(Verdict::match),
                   replay.cells.size() - replay.count(Verdict::input), replay.method);
    append_cells(text, replay, all_cells);
    append_costs(text, replay);
  }
  return folded(text);
}

Json tables_json(const std::vector<Replay>& replays) {
  const Counts counts = count(replays);
  return {{"tables", json_list(replays, table_json)},
          {"summary",
           {{"cells", counts.cells},
            {"match", counts.match},
            {"misprint", counts.misprint},
            {"seed_error", counts.seed_error},
            {"unexplained", counts.unexplained},
            {"without_number", counts.without_number}}}};
}

std::string table_list_text(const std::vector<data::TableSummary>& summaries) {
  TextTable table(
      {"table", ">rows", ">columns", ">cells", ">empty", ">identity", ">trend", ">glyph", ">unreadable"});
  const auto add = [&](const data::TableSummary& row, const std::string& columns) {
    std::vector<std::string> cells{row.id, std::to_string(row.rows), columns, std::to_string(row.cells),
                                   std::to_string(row.empty)};
    for (const std::size_t of_kind : row.errata) cells.push_back(std::to_string(of_kind));
    table.add(std::move(cells));
  };
  data::TableSummary sum{};
  sum.id = "sum";
  for (const data::TableSummary& one : summaries) {
    add(one, std::to_string(one.columns));
    table.add_below(one.title);
    sum.rows += one.rows;
    sum.cells += one.cells;
    sum.empty += one.empty;
    for (std::size_t kind = 0; kind < sum.errata.size(); ++kind) sum.errata[kind] += one.errata[kind];
  }
  add(sum, "");
  return table.text();
}

Json table_list_json(const std::vector<data::TableSummary>& summaries) {
  return {{"listed", json_list(summaries, [](const data::TableSummary& table) {
             return Json{{"id", table.id},
                         {"title", table.title},
                         {"rows", table.rows},
                         {"columns", table.columns},
                         {"cells", table.cells},
                         {"empty", table.empty},
                         {"without_value", table.without_value},
                         {"doubtful", table.doubtful},
                         {"errata", errata_json(table)},
                         {"row_label_errata", table.key_errata}};
           })}};
}

}  // namespace nipref::verify
