#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {
namespace {

const data::TableCell& printed_cell(const Replay& replay, const ReplayedCell& cell) {
  return replay.table.cell(cell.row, cell.column);
}

/// Whether an unexplained cell has no legible number.
bool is_without_number(const Replay& replay, const ReplayedCell& cell) {
  return cell.verdict == Verdict::unexplained && !printed_cell(replay, cell).is_readable();
}

/// Whether a cell matches although one of its digits is lost, so that any digit in that place is accepted.
bool matches_with_lost_digit(const Replay& replay, const ReplayedCell& cell) {
  return cell.verdict == Verdict::match && printed_cell(replay, cell).has_lost_digit();
}

/// The numbers of cells of each verdict; inputs are not counted.
Json summary_json(const std::vector<Replay>& replays) {
  const auto count = [&](const auto& is_so) {
    std::ptrdiff_t total = 0;
    for (const Replay& replay : replays)
      total += std::ranges::count_if(replay.cells, [&](const auto& cell) { return is_so(replay, cell); });
    return total;
  };
  const auto of = [&](Verdict verdict) {
    return count([=](const Replay&, const ReplayedCell& cell) { return cell.verdict == verdict; });
  };
  return {{"cells", count([](const Replay&, const auto& cell) { return cell.verdict != Verdict::input; })},
          {"match", of(Verdict::match)},
          {"with_lost_digit", count(matches_with_lost_digit)},
          {"misprint", of(Verdict::misprint)},
          {"likely_misprint", of(Verdict::likely_misprint)},
          {"seed_error", of(Verdict::seed_error)},
          {"unexplained", of(Verdict::unexplained)},
          {"without_number", count(is_without_number)}};
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

/// A value as a JSON number; null if there is none.
Json scaled_json(const Replay& replay, const ReplayedCell& cell, const std::optional<double>& value) {
  return value ? Json::number(scaled_text(replay, cell, *value)) : Json();
}

/// The errors that each weakness of the seed's method causes.
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

Json cell_json(const Replay& replay, const ReplayedCell& cell, bool all) {
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
          {"note", Json::unless_empty(cell.note)},
          {"_input", cell.verdict == Verdict::input},
          {"_good", cell.verdict == Verdict::match},
          {"_range",
           scaled_text(replay, cell, cell.range.lower) + ".." + scaled_text(replay, cell, cell.range.upper)},
          {"_corrected", cell.corrected ? scaled_text(replay, cell, *cell.corrected) : "-"},
          {"_shown", all || (cell.verdict != Verdict::input && cell.verdict != Verdict::match)}};
}

Json errata_json(const data::TableSummary& table) {
  Json errata = Json::object();
  for (std::size_t kind = 0; kind < table.errata.size(); ++kind)
    errata.set(data::erratum_kind_names[kind], table.errata[kind]);
  return errata;
}

/// The columns that label rows, or with `keys` false the other columns.
Json columns_json(const data::Table& table, bool keys) {
  std::vector<Json> columns;
  for (const data::TableColumn& column : table.columns) {
    if (column.is_key == keys)
      columns.push_back({{"column", column.name},
                         {"unit", column.unit == "1" ? Json() : Json(column.unit)},
                         {"power_of_ten", column.scale_exponent == 0 ? Json() : Json(column.scale_exponent)},
                         {"meaning", column.meaning}});
  }
  return columns;
}

Json table_json(const Replay& replay, bool all) {
  const auto to_json = [&](const ReplayedCell& cell) { return cell_json(replay, cell, all); };
  return {{"id", replay.table.id},
          {"title", replay.table.title},
          {"method", replay.method},
          {"keys", columns_json(replay.table, true)},
          {"columns", columns_json(replay.table, false)},
          {"costs", costs_json(replay)},
          {"cells", json_list(replay.cells, to_json)},
          {"_match", replay.count(Verdict::match)},
          {"_judged", replay.cells.size() - replay.count(Verdict::input)},
          {"_costs", cost_list_json(replay)}};
}

Json table_row_json(const data::TableSummary& table) {
  return {{"id", table.id},
          {"title", table.title},
          {"rows", table.rows},
          {"columns", table.columns},
          {"cells", table.cells},
          {"empty", table.empty},
          {"without_value", table.without_value},
          {"doubtful", table.doubtful},
          {"errata", errata_json(table)},
          {"row_label_errata", table.key_errata}};
}

}  // namespace

std::string scaled_text(const Replay& replay, const ReplayedCell& cell, double value) {
  const int exponent = replay.table.columns[replay.table.column_index(cell.column)].scale_exponent;
  return fmt::format("{:.{}f}", value * std::pow(10.0, exponent), decimals_of(replay, cell) + 2);
}

Json column_json(const ColumnDeviation& column) {
  return {{"column", column.column}, {"mean", column.mean}, {"largest", column.largest}};
}

Json cost_list_json(const Replay& replay) {
  return json_list(replay.costs, [](const Cost& cost) {
    return Json{{"weakness", cost.weakness},
                {"against", cost.against},
                {"columns", json_list(cost.columns, column_json)}};
  });
}

Json tables_json(const std::vector<Replay>& replays, bool all_cells) {
  const auto to_json = [&](const Replay& replay) { return table_json(replay, all_cells); };
  return {{"tables", json_list(replays, to_json)}, {"summary", summary_json(replays)}};
}

Json table_list_json(const std::vector<data::TableSummary>& summaries) {
  data::TableSummary sum{};
  for (const data::TableSummary& one : summaries) {
    sum.rows += one.rows;
    sum.cells += one.cells;
    sum.empty += one.empty;
    for (std::size_t kind = 0; kind < sum.errata.size(); ++kind) sum.errata[kind] += one.errata[kind];
  }
  return {{"listed", json_list(summaries, table_row_json)}, {"_sum", table_row_json(sum)}};
}

}  // namespace nipref::verify
