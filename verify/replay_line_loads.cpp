#include "verify/replay_line_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "data/bad_input.hpp"
#include "fast/contact_line_loads.hpp"

namespace nipref::verify {
namespace {

/// Young's modulus that reproduces the thesis's elastic tables; the 1.45e5 psi it states reproduces none of
/// them.
constexpr double young_of_the_tables = 1.40536e5;

/// The columns of a row, base units, by name.
using Row = std::map<std::string, double>;

Row replay_row(const data::ElasticNip& nip, int elements_per_side, double contact_length) {
  const auto solution = fast::line_loads_for_length(nip, elements_per_side, contact_length);
  const double thickness = nip.sheet_thickness;
  return {{"W", solution.load},
          {"L", contact_length},
          {"d0", solution.indentation},
          {"d1", solution.edge_displacement},
          {"creep", fast::creep_ratio(nip, solution)},
          {"p_max", solution.peak_pressure},
          {"L/B", contact_length / thickness},
          {"d0/B", solution.indentation / thickness},
          {"d1/B", solution.edge_displacement / thickness},
          {"d1/d0", solution.edge_displacement / solution.indentation}};
}

std::string load_note(double replayed, double stated) {
  return fmt::format("replay's load at this length {:.4g} for {:g} ({:+.2f} %)", replayed, stated,
                     100 * (replayed / stated - 1));
}

/// A row of one table, with what its replay needs.
class RowReplay {
 public:
  RowReplay(const data::Table& table, std::size_t row, const data::ElasticNip& nip, int elements_per_side)
      : table_(table), row_(row), nip_(nip), elements_per_side_(elements_per_side) {
    const data::TableCell& length = table.cell(row, "L");
    if (!length.is_readable())
      throw data::BadInput("L", length.printed, "must be readable to replay its row");
    input_ = *length.number;
    at_ = replay_over(input_.rounding);
  }

  [[nodiscard]] ReplayedCell replay(const std::string& column) const {
    const data::TableCell& cell = table_.cell(row_, column);
    if (column == "L") {
      const double stated = table_.cell(row_, "W").number->value;
      return {row_, column, input_.value, input_.rounding, Verdict::input, load_note(at_[1].at("W"), stated)};
    }
    const data::Interval range = range_of(at_, column);
    const Verdict verdict = judge(cell, range);
    return {row_, column, at_[1].at(column), range, verdict, note(cell, column, verdict)};
  }

 private:
  using Rows = std::array<Row, 3>;

  [[nodiscard]] Rows replay_over(const data::Interval& length) const {
    return {replay_row(nip_, elements_per_side_, length.lower),
            replay_row(nip_, elements_per_side_, std::midpoint(length.lower, length.upper)),
            replay_row(nip_, elements_per_side_, length.upper)};
  }

  static data::Interval range_of(const Rows& rows, const std::string& column) {
    const auto [low, high] = std::minmax({rows[0].at(column), rows[1].at(column), rows[2].at(column)});
    return {low, high};
  }

  /// The length as the cell L/B of the same row gives it.
  [[nodiscard]] data::Interval length_from_ratio() const {
    const data::Interval& ratio = table_.cell(row_, "L/B").number->rounding;
    return {ratio.lower * nip_.sheet_thickness, ratio.upper * nip_.sheet_thickness};
  }

  [[nodiscard]] std::string note(const data::TableCell& cell, const std::string& column,
                                 Verdict verdict) const {
    if (verdict == Verdict::match) return "";
    if (cell.erratum) return cell.erratum->reason;
    if (!table_.cell(row_, "L").is_doubtful()) return "";
    const bool met = judge(cell, range_of(replay_over(length_from_ratio()), column)) == Verdict::match;
    return fmt::format("the row's L and L/B contradict each other; {} at the L of L/B",
                       met ? "met" : "not met either");
  }

  const data::Table& table_;
  std::size_t row_;
  const data::ElasticNip& nip_;
  int elements_per_side_;
  data::PrintedNumber input_{};
  Rows at_;
};

}  // namespace

Replay replay_frictionless_line_loads(data::Table table, int elements_per_side) {
  const data::ElasticNip nip{table.parameter("R").value,
                             table.parameter("B").value,
                             {young_of_the_tables, table.parameter("poisson").value}};
  Replay replay{std::move(table),
                fmt::format("line loads without friction (5.11)-(5.16), {} elements a side, E = {:g} psi",
                            elements_per_side, nip.material.young),
                {}};
  for (std::size_t row = 0; row < replay.table.rows.size(); ++row) {
    const RowReplay cells(replay.table, row, nip, elements_per_side);
    for (const data::TableColumn& column : replay.table.columns) {
      if (!column.is_key) replay.cells.push_back(cells.replay(column.name));
    }
  }
  return replay;
}

}  // namespace nipref::verify
