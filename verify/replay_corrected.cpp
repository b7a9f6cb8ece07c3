#include "verify/replay_corrected.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fast/contact_converged.hpp"
#include "fast/contact_line_loads_grip.hpp"
#include "verify/replay_line_loads.hpp"
#include "verify/replay_row.hpp"

namespace nipref::verify {
namespace {

constexpr double accuracy = 1e-9;
constexpr std::array<const char*, 3> compared{"L", "d0", "p_max"};

RowValues converged_row(const data::ElasticNip& nip, data::Friction friction, double load) {
  const fast::ConvergedContact contact = fast::converged_for_load(nip, friction, load, accuracy);
  fast::LineLoadSolution numbers{contact.contact_length().value,    contact.indentation().value,
                                 contact.edge_displacement().value, contact.load().value,
                                 contact.peak_pressure().value,     {}};
  if (friction == data::Friction::full) numbers.peak_shear = contact.peak_shear().value;
  return row_values(nip, numbers, contact.creep_ratio().value);
}

/// The row's replay, from the inputs as they stand.
RowValues line_load_row(const Replay& replay, const data::ElasticNip& nip, const LineLoadTable& how,
                        std::size_t row) {
  const auto input = [&](const std::string& column) {
    return std::ranges::find_if(
               replay.cells,
               [&](const ReplayedCell& cell) { return cell.row == row && cell.column == column; })
        ->value;
  };
  return how.friction == data::Friction::none
             ? row_values(nip, fast::line_loads_for_length(nip, how.elements_per_side, input("L")), 0)
             : row_values(nip,
                          fast::gripped_line_loads_for_length(nip, how.elements_per_side, input("L"),
                                                              input("creep")),
                          input("creep"));
}

/// Deviations of rows of one column, gathered.
Deviation gather(const std::string& column, const std::vector<RowValues>& rows,
                 const std::vector<RowValues>& truth) {
  Deviation deviation{column, 0, 0};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const double relative = rows[row].at(column) / truth[row].at(column) - 1;
    deviation.mean += std::abs(relative) / static_cast<double>(rows.size());
    if (std::abs(relative) > std::abs(deviation.largest)) deviation.largest = relative;
  }
  return deviation;
}

}  // namespace

void correct(Replay& replay) {
  const LineLoadTable& how = line_load_table(replay.table.id);
  const data::ElasticNip nip = nip_of_the_tables(replay.table);
  std::vector<RowValues> corrected;
  std::vector<RowValues> line_loads;
  std::vector<RowValues> truth;
  for (std::size_t row = 0; row < replay.table.rows.size(); ++row) {
    corrected.push_back(converged_row(nip, how.friction, replay.table.cell(row, "W").number->value));
    line_loads.push_back(line_load_row(replay, nip, how, row));
    truth.push_back(converged_row(nip, how.friction, line_loads.back().at("W")));
  }
  for (ReplayedCell& cell : replay.cells) cell.corrected = corrected[cell.row].at(cell.column);
  replay.discretisation.clear();
  for (const char* column : compared) replay.discretisation.push_back(gather(column, line_loads, truth));
}

}  // namespace nipref::verify
