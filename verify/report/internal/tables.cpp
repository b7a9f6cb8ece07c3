#include <fmt/format.h>

#include <cmath>

#include <nipref/verify/replay/render.hpp>
#include <nipref/verify/report/internal/counts.hpp>
#include <nipref/verify/report/internal/sections.hpp>

namespace nipref::verify {
namespace {

/// What tells verdicts apart where colours do not.
std::string_view mark_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::input:
      return "\u00b7";
    case Verdict::match:
      return "\u2713";
    case Verdict::misprint:
      return "\u270e";
    case Verdict::seed_error:
      return "\u2717";
    case Verdict::unexplained:
      return "?";
  }
  return "";
}

std::string printed_text(const data::TableCell& cell) {
  return cell.printed.empty() ? "(empty)" : cell.printed;
}

std::string row_name(const Replay& replay, std::size_t row) {
  std::string text;
  for (std::size_t i = 0; i < replay.table.columns.size(); ++i) {
    const data::TableColumn& column = replay.table.columns[i];
    if (column.is_key)
      text +=
          fmt::format("{}{} = {}", text.empty() ? "" : ", ", column.name, replay.table.rows[row][i].read_as);
  }
  return text.empty() ? fmt::format("row {}", row + 1) : text;
}

const ReplayedCell* replayed_cell(const Replay& replay, std::size_t row, const std::string& column) {
  for (const ReplayedCell& cell : replay.cells) {
    if (cell.row == row && cell.column == column) return &cell;
  }
  return nullptr;
}

/// The table as it was printed, with a mark and a colour in each cell.
Markup printed_table(const Replay& replay) {
  std::vector<std::string> headings{"row"};
  for (const data::TableColumn& column : replay.table.columns) {
    if (!column.is_key) headings.push_back("#" + column.name);
  }
  TableMarkup table("As printed, with what is made of each cell", headings);
  for (std::size_t row = 0; row < replay.table.rows.size(); ++row) {
    std::vector<TableCellMarkup> cells{{row_name(replay, row), false, "keep"}};
    for (std::size_t i = 0; i < replay.table.columns.size(); ++i) {
      const data::TableColumn& column = replay.table.columns[i];
      if (column.is_key) continue;
      const std::string printed = printed_text(replay.table.rows[row][i]);
      const ReplayedCell* const cell = replayed_cell(replay, row, column.name);
      cells.push_back(cell == nullptr ? number_cell(printed)
                                      : TableCellMarkup{printed + " " + std::string(mark_of(cell->verdict)),
                                                        true, std::string(name(cell->verdict))});
    }
    table.row(cells);
  }
  return table.markup();
}

Markup all_cells(const Replay& replay) {
  TableMarkup table("Each cell", {"row", "column", "verdict", "#printed", "#read as", "#replayed, from",
                                  "#to", "#corrected", "why"});
  for (const ReplayedCell& cell : replay.cells) {
    if (cell.verdict == Verdict::input) continue;
    const data::TableCell& printed = replay.table.cell(cell.row, cell.column);
    table.row({{row_name(replay, cell.row), false, "keep"},
               {cell.column},
               {std::string(mark_of(cell.verdict)) + " " + std::string(name(cell.verdict)), false,
                "keep " + std::string(name(cell.verdict))},
               number_cell(printed_text(printed)),
               number_cell(printed.is_readable() ? printed.read_as : "-"),
               number_cell(scaled_text(replay, cell, cell.range.lower)),
               number_cell(scaled_text(replay, cell, cell.range.upper)),
               number_cell(cell.corrected ? scaled_text(replay, cell, *cell.corrected) : "-"),
               {cell.note, false, "wide"}});
  }
  return table.markup();
}

Markup costs_list(const Replay& replay) {
  Markup items;
  for (const Cost& cost : replay.costs) {
    std::string text = fmt::format("{} ({}): ", cost.weakness, cost.against);
    for (const ColumnDeviation& column : cost.columns)
      text += fmt::format("{}{} {:.2g} % in the mean, {:+.2g} % at most",
                          &column == &cost.columns.front() ? "" : "; ", column.column, 100 * column.mean,
                          100 * column.largest);
    items += element("li", text);
  }
  return items.html().empty() ? Markup()
                              : element("p", "What the seed's method costs:") + element("ul", items);
}

Markup table_details(const Replay& replay) {
  std::string counts;
  for (const Verdict verdict : {Verdict::match, Verdict::misprint, Verdict::seed_error, Verdict::unexplained})
    counts +=
        fmt::format("{}{} {}", verdict == Verdict::match ? "" : ", ", replay.count(verdict), name(verdict));
  return details(element("span", replay.table.id) + " " +
                     element("span", {{"class", "soft"}}, replay.table.title + ": " + counts),
                 element("p", replay.method) + costs_list(replay) + printed_table(replay) +
                     details("Each cell: printed, read, replayed, corrected, why", all_cells(replay)),
                 {{"id", replay.table.id}});
}

Markup summary_table(const std::vector<Replay>& tables) {
  TableMarkup table("All tables; cells that serve as the replay's inputs are not counted",
                    {"table", "#cells", "#\u2713 match", "#\u270e misprint", "#\u2717 seed-error",
                     "#? unexplained", "#worst column at the row's own load"});
  for (const Replay& replay : tables) {
    const ColumnDeviation* worst = nullptr;
    for (const Cost& cost : replay.costs) {
      for (const ColumnDeviation& column : cost.columns) {
        if (worst == nullptr || std::fabs(column.largest) > std::fabs(worst->largest)) worst = &column;
      }
    }
    table.row({{link_to(replay.table.id, replay.table.id), false, "keep"},
               number_cell(std::to_string(replay.cells.size() - replay.count(Verdict::input))),
               number_cell(std::to_string(replay.count(Verdict::match))),
               number_cell(std::to_string(replay.count(Verdict::misprint))),
               number_cell(std::to_string(replay.count(Verdict::seed_error))),
               number_cell(std::to_string(replay.count(Verdict::unexplained))),
               number_cell(worst == nullptr ? "-" : worst->column + ": " + off_text(worst->largest))});
  }
  return table.markup();
}

}  // namespace

Markup tables_section(const Report& report) {
  Markup all;
  for (const Replay& replay : report.tables) all += table_details(replay);
  return section(
      "tables", "Tables of the seeds, replayed",
      element(
          "p",
          "Each table is computed again by the seed's own method, as coarse as it was. A cell matches (\u2713) where the number, "
          "with its rounding, lies in what the method gives as the row's inputs range over theirs. \u270e misprint: it does once the "
          "table's own redundancy has corrected the text. \u2717 seed-error: the seed's method or formula is wrong there, and how is "
          "known. ? unexplained: neither, or nothing legible. \u00b7 input: what the row is replayed from. Corrected is what is true.") +
          summary_table(report.tables) + all);
}

}  // namespace nipref::verify
