#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/fast/half_space/transversely_isotropic.hpp>
#include <nipref/verify/replay/internal/half_space.hpp>
#include <nipref/verify/replay/internal/readings.hpp>

namespace nipref::verify {
namespace {

constexpr std::array<HalfSpaceTable, 5> papers_tables{
    {{"brock2012-1", sliding_die_cells,
      "(brock2012 35) with sqrt(c_D^4 + gamma^2)/2 and without friction in Delta_1 and Q_1"},
     {"brock2012-2", rolling_sphere_cells, "(brock2012 53b) without the c_D under its root"},
     {"brock2013-1", sphere_on_normal_axis_cells, "(brock2013 35) with (25c), both as printed"},
     {"brock2013-2", branch_speed_cells,
      "(brock2013 46) with P6 corrected; in c_plus and c_minus d1 = 0.1803"},
     {"brock2013-3", sphere_on_axis_in_plane_cells,
      "(brock2013 48) with a minus sign before the first term of (43b), the last term of M still missing"}}};

/// Whether the row's cells are 1 because all numbers of the table are divided by those of this row.
bool is_unit(const data::Table& table, std::size_t row) {
  return table.has_column("phi") && table.cell(row, "phi").number->value == 0;
}

std::vector<ColumnDeviation> deviations_from_corrected(const Replay& replay) {
  std::vector<ColumnDeviation> columns;
  for (const data::TableColumn& column : replay.table.columns) {
    if (column.is_key) continue;
    ColumnDeviation deviation{column.name, 0, 0};
    double cells = 0;
    for (const ReplayedCell& cell : replay.cells) {
      if (cell.column != column.name || cell.verdict == Verdict::input) continue;
      const double relative = cell.value / *cell.corrected - 1;
      deviation.mean += std::fabs(relative);
      cells += 1;
      if (std::fabs(relative) > std::fabs(deviation.largest)) deviation.largest = relative;
    }
    deviation.mean /= cells;
    columns.push_back(std::move(deviation));
  }
  return columns;
}

constexpr double table_unit = 1e-4;
constexpr double binary = 1e-12;  ///< exceeds the rounding errors of decimal numbers in double

double distance(double value, const data::Interval& range) {
  return std::max({0.0, range.lower - value, value - range.upper});
}

std::string units_away(const data::TableCell& cell, const Attempt& attempt) {
  return fmt::format("{:+.1f} units of the fourth decimal from {:.5f}",
                     (cell.number->value - attempt.range.middle()) / table_unit, attempt.range.middle());
}

/// How far the printed number is from each attempt, if none of them matches.
std::string formula_note(const data::TableCell& printed, const HalfSpaceCell& cell) {
  std::string text = units_away(printed, cell.attempts.front()) + ", which the table's formula gives";
  for (std::size_t i = 1; i < cell.attempts.size(); ++i)
    text += fmt::format("; {} ({})", units_away(printed, cell.attempts[i]), cell.attempts[i].how);
  return text;
}

std::string unexplained_note(const data::Table& table, const HalfSpaceCell& cell) {
  const data::TableCell& printed = table.cell(cell.row, cell.column);
  return all_outcomes({printed.erratum ? printed.erratum->reason : "",
                       one_digit(table, cell.row, cell.column, cell.attempts.front().range),
                       formula_note(printed, cell),
                       cell.error.empty() ? "" : "that formula is wrong: " + cell.error});
}

/// Turns a match into a misprint if the number that matches is an erratum's reading.
ReplayedCell corrected_by_erratum(ReplayedCell cell, const data::Table& table) {
  const data::TableCell& printed = table.cell(cell.row, cell.column);
  if (printed.read_as == printed.printed) return cell;
  if (cell.verdict == Verdict::match) {
    cell.verdict = Verdict::misprint;
    cell.note = printed.erratum->reason;
  }
  judge_reading(table, cell, cell.range);
  return cell;
}

}  // namespace

std::span<const HalfSpaceTable> half_space_tables() { return papers_tables; }

Replay replay_half_space(data::Table table, const HalfSpaceTable& how) {
  Replay replay{std::move(table), std::string(how.method), {}};
  const CellOf cell_of = how.cell_of(replay.table);
  for (std::size_t row = 0; row < replay.table.rows.size(); ++row) {
    for (const data::TableColumn& column : replay.table.columns) {
      if (column.is_key) continue;
      ReplayedCell cell{row, column.name, 1, {1, 1}, Verdict::input, "1 by definition (brock2013 48)"};
      cell.corrected = 1;
      if (!is_unit(replay.table, row)) cell = assess_half_space(replay.table, cell_of(row, column));
      replay.cells.push_back(std::move(cell));
    }
  }
  replay.costs = {{"formula", "against the corrected formula in the same contour rule",
                   deviations_from_corrected(replay)}};
  return replay;
}

SphereOnHalfSpace::SphereOnHalfSpace(const data::Table& table) {
  const auto value = [&](const char* name) { return table.parameter(name).value; };
  const double c_d = value("c_D");
  const double mu0 = value("mu0");
  sphere = {mu0, (c_d * c_d - 2) / (2 * (c_d * c_d - 1)), value("rho0")};
  half_space = {value("C11"), value("C33"), value("C13"), value("C55"), value("C66"), value("rho")};
  scaled = scaled_moduli(half_space, sphere);
  scaled.back().second = c_d;
}

fast::SurfaceResponse SphereOnHalfSpace::in_contact(data::SymmetryAxis axis, fast::Direction motion,
                                                    double c0) const {
  const double speed = c0 * speed_unit();
  const auto surface =
      std::make_shared<const fast::TransverselyIsotropicHalfSpace>(half_space, axis, motion, speed);
  return [=, sphere = sphere](fast::Direction from_motion) -> fast::LineResponse {
    const fast::LineResponse lower = surface->along(from_motion.turned(motion));
    const fast::LineResponse upper = fast::isotropic_response(sphere, speed, from_motion);
    return fast::in_contact(lower, upper);
  };
}

ReplayedCell assess_half_space(const data::Table& table, const HalfSpaceCell& cell) {
  const data::TableCell& printed = table.cell(cell.row, cell.column);
  const double value = printed.number->value;
  const data::Interval& formula = cell.attempts.front().range;
  ReplayedCell result{cell.row, cell.column, formula.middle(), formula, Verdict::unexplained, ""};
  result.corrected = cell.corrected;
  result.exact = cell.exact;
  if (std::fabs(value - cell.corrected) <= table_unit + binary) {
    result.verdict = Verdict::match;
    return corrected_by_erratum(result, table);
  }
  const auto met = std::ranges::find_if(cell.attempts, [&](const Attempt& attempt) {
    return distance(value, attempt.range) <= printed.number->rounding.width() + binary;
  });
  if (met != cell.attempts.end()) {
    result.value = met->range.middle();
    result.range = met->range;
    result.verdict = met->if_met;
    result.note = all_outcomes({cell.error, met->how});
  } else if (!cell.proof.empty() && !printed.is_doubtful()) {
    result.verdict = Verdict::seed_error;
    result.note = cell.proof + "; " + formula_note(printed, cell);
  } else {
    result.note = unexplained_note(table, cell);
  }
  return corrected_by_erratum(result, table);
}

}  // namespace nipref::verify
