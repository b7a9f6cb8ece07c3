#include <cmath>

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/verify/replay/internal/elastic_nip.hpp>
#include <nipref/verify/replay/internal/half_space.hpp>
#include <nipref/verify/replay/internal/viscoelastic_nip.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {
namespace {

constexpr double accuracy = 1e-9;

RowValues converged_row(const data::ElasticNip& nip, data::Friction friction, double load) {
  const fast::ConvergedElasticNip contact = fast::converged_for_load(nip, friction, load, accuracy);
  fast::LineLoadSolution numbers{contact.contact_length().value,    contact.indentation().value,
                                 contact.edge_displacement().value, contact.load().value,
                                 contact.peak_pressure().value,     {}};
  if (friction == data::Friction::full) numbers.peak_shear = contact.peak_shear().value;
  return row_values(nip, numbers, contact.creep_ratio().value);
}

void correct_elastic(Replay& replay) {
  const LineLoadTable& how = line_load_table(replay.table.id);
  const data::ElasticNip nip = nip_of_the_tables(replay.table);
  std::vector<RowValues> corrected;
  std::vector<RowValues> line_loads;
  std::vector<RowValues> truth;
  for (std::size_t row = 0; row < replay.table.rows.size(); ++row) {
    corrected.push_back(converged_row(nip, how.friction, replay.table.cell(row, "W").number->value));
    line_loads.push_back(replay.nips[row].values);
    truth.push_back(converged_row(nip, how.friction, line_loads.back().at("W")));
  }
  for (ReplayedCell& cell : replay.cells) cell.corrected = corrected[cell.row].at(cell.column);
  replay.costs = {{"discretisation", "against the continuous contact of the same load",
                   deviations({"L", "d0", "p_max"}, line_loads, truth)}};
}

}  // namespace

std::vector<ColumnDeviation> deviations(std::initializer_list<const char*> columns,
                                        const std::vector<RowValues>& rows,
                                        const std::vector<RowValues>& truth) {
  std::vector<ColumnDeviation> result;
  for (const char* column : columns) {
    ColumnDeviation deviation{column, 0, 0};
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const double relative = rows[row].at(column) / truth[row].at(column) - 1;
      deviation.mean += std::abs(relative) / static_cast<double>(rows.size());
      if (std::abs(relative) > std::abs(deviation.largest)) deviation.largest = relative;
    }
    result.push_back(std::move(deviation));
  }
  return result;
}

void correct(Replay& replay) {
  if (find_half_space_table(replay.table.id) != nullptr)
    return;  // its replay has the corrected values already
  if (find_viscoelastic_table(replay.table.id) != nullptr) {
    correct_viscoelastic(replay);
  } else {
    correct_elastic(replay);
  }
}

}  // namespace nipref::verify
