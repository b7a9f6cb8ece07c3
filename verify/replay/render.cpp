#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <nipref/verify/replay/render.hpp>

namespace nipref::verify {
namespace {

struct Counts {
  std::size_t cells = 0;  ///< without inputs
  std::size_t match = 0;
  std::size_t misprint = 0;
  std::size_t seed_error = 0;
  std::size_t unexplained = 0;
  std::size_t without_number = 0;  ///< of the unexplained: nothing legible to compare
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

/// Of the cell as it is read; of the finest cell in its column if it cannot be read.
std::size_t decimals_of(const Replay& replay, const ReplayedCell& cell) {
  const data::TableCell& printed = printed_cell(replay, cell);
  if (printed.is_readable()) return decimals(printed.read_as);
  const std::size_t column = replay.table.column_index(cell.column);
  std::size_t finest = 0;
  for (const auto& row : replay.table.rows) finest = std::max(finest, decimals(row[column].read_as));
  return finest;
}

/// A number in the scaling that its column is printed in, with two digits more than the printed cell.
std::string scaled(const Replay& replay, const ReplayedCell& cell, double value) {
  const int exponent = replay.table.columns[replay.table.column_index(cell.column)].scale_exponent;
  return fmt::format("{:.{}f}", value * std::pow(10.0, exponent), decimals_of(replay, cell) + 2);
}

/// Nothing if it was not computed.
std::optional<std::string> scaled(const Replay& replay, const ReplayedCell& cell,
                                  const std::optional<double>& value) {
  return value ? std::optional(scaled(replay, cell, *value)) : std::nullopt;
}

std::string row_label(const Replay& replay, std::size_t row) {
  std::string label;
  for (std::size_t i = 0; i < replay.table.columns.size(); ++i) {
    const data::TableColumn& column = replay.table.columns[i];
    if (column.is_key) label += fmt::format("{}={}", column.name, replay.table.rows[row][i].read_as);
  }
  return label;
}

void append_full(std::string& text, const Replay& replay) {
  auto out = std::back_inserter(text);
  fmt::format_to(out, "{:>8} {:>7} {:>10} {:>22} {:>12} {:>12}  {}\n", "row", "column", "printed",
                 "replayed range", "corrected", "verdict", "note");
  for (const ReplayedCell& cell : replay.cells) {
    const std::string range = fmt::format("{} .. {}", scaled(replay, cell, cell.range.lower),
                                          scaled(replay, cell, cell.range.upper));
    fmt::format_to(out, "{:>8} {:>7} {:>10} {:>22} {:>12} {:>12}  {}\n", row_label(replay, cell.row),
                   cell.column, printed_cell(replay, cell).printed, range,
                   scaled(replay, cell, cell.corrected).value_or("-"), name(cell.verdict), cell.note);
  }
}

/// What the weaknesses of the seed's method cost.
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

/// The number that `scaled` prints.
Json scaled_json(const Replay& replay, const ReplayedCell& cell, const std::optional<double>& value) {
  return value ? Json::number(scaled(replay, cell, *value)) : Json();
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

void append_exceptions(std::string& text, const Replay& replay) {
  for (const ReplayedCell& cell : replay.cells) {
    if (cell.verdict == Verdict::input || cell.verdict == Verdict::match) continue;
    fmt::format_to(std::back_inserter(text), "  {} {} printed {}, replayed {} .. {}: {}. {}\n",
                   row_label(replay, cell.row), cell.column, printed_cell(replay, cell).printed,
                   scaled(replay, cell, cell.range.lower), scaled(replay, cell, cell.range.upper),
                   name(cell.verdict), cell.note);
  }
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

std::string tables_text(const std::vector<Replay>& replays, bool compact) {
  std::string text;
  for (const Replay& replay : replays) {
    fmt::format_to(std::back_inserter(text), "{}: {}\n  {}\n", replay.table.id, replay.table.title,
                   replay.method);
    compact ? append_exceptions(text, replay) : append_full(text, replay);
    append_costs(text, replay);
  }
  const Counts counts = count(replays);
  fmt::format_to(std::back_inserter(text),
                 "{} cells (inputs not counted): {} match, {} misprint, {} seed-error, {} unexplained, of "
                 "which {} have no number\n",
                 counts.cells, counts.match, counts.misprint, counts.seed_error, counts.unexplained,
                 counts.without_number);
  return text;
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
  std::string text =
      fmt::format("{:13} {:>4} {:>7} {:>5} {:>5} {:>8} {:>5} {:>5} {:>10}  {}\n", "table", "rows", "columns",
                  "cells", "empty", "identity", "trend", "glyph", "unreadable", "title");
  data::TableSummary sum{};
  for (const data::TableSummary& table : summaries) {
    fmt::format_to(std::back_inserter(text), "{:13} {:>4} {:>7} {:>5} {:>5} {:>8} {:>5} {:>5} {:>10}  {}\n",
                   table.id, table.rows, table.columns, table.cells, table.empty, table.errata[0],
                   table.errata[1], table.errata[2], table.errata[3], table.title);
    sum.rows += table.rows;
    sum.cells += table.cells;
    sum.empty += table.empty;
    for (std::size_t kind = 0; kind < sum.errata.size(); ++kind) sum.errata[kind] += table.errata[kind];
  }
  fmt::format_to(std::back_inserter(text), "{:13} {:>4} {:>7} {:>5} {:>5} {:>8} {:>5} {:>5} {:>10}\n", "sum",
                 sum.rows, "", sum.cells, sum.empty, sum.errata[0], sum.errata[1], sum.errata[2],
                 sum.errata[3]);
  return text;
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
