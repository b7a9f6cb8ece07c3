#include <cmath>
#include <vector>

#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/verify/replay/internal/half_space.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/internal/parallel.hpp>
#include <nipref/verify/support/mapped.hpp>

namespace nipref::verify {
namespace {

constexpr double rolling_accuracy = 1e-6;

RowValues continuous(const data::ViscoelasticNip& nip, double load) {
  return row_values(nip.sheet_thickness, fast::converged_for_load(nip, load, rolling_accuracy));
}

/// The results for one row besides its replay.
struct CorrectedRow {
  RowValues corrected, with_seed_material;               ///< at the table's load
  RowValues all_terms, exact_kernels, mesh, no_mistake;  ///< at the replay's load
};

CorrectedRow correct_row(const Replay& replay, std::size_t row, const ViscoelasticTable& how) {
  const auto defined = viscoelastic_nip_of_the_tables(replay.table, row, true);
  const auto printed = viscoelastic_nip_of_the_tables(replay.table, row, false);
  const double stated = replay.table.parameter("W").value;
  data::ViscoelasticLineLoads method = viscoelastic_method(how);
  method.trailing_elements = replay.nips[row].trailing_elements;
  CorrectedRow result;
  result.corrected = continuous(defined, stated);
  result.with_seed_material = continuous(printed, stated);
  const double load = replay.nips[row].values.at("W");
  const auto line_loads = [&] {
    return row_values(printed.sheet_thickness, fast::line_loads_for_load(printed, method, load));
  };
  method.smallest_term = 0;
  result.all_terms = line_loads();
  method.residue_terms = 0;
  result.exact_kernels = line_loads();
  result.mesh = continuous(printed, load);
  result.no_mistake = continuous(defined, load);
  return result;
}

/// Sets these members of a replay of thesis XI-XXVI:
///   - `corrected`: the continuous contact under the table's load, accurate to 1e-6, of the solid that the thesis defines,
///     with one relaxation time in shear and dilatation;
///   - `corrected_with_seed_material`: the same with the thesis's theta2;
///   - `costs` in L, d0, p_max and muR at the load of the row's replay: "stop" compares the replay with the same line
///     loads without its smallest_term, "truncation" these with exact kernels, "discretisation" those with the continuous
///     contact, and "exponent" the continuous contacts with the thesis's theta2 and with the solid's.
void correct_viscoelastic(Replay& replay) {
  const ViscoelasticTable& how = *find_viscoelastic_table(replay.table.id);
  const auto rows = parallel_mapped(replay.table.rows.size(),
                                    [&](std::size_t row) { return correct_row(replay, row, how); });
  for (ReplayedCell& cell : replay.cells) {
    cell.corrected = rows[cell.row].corrected.at(cell.column);
    cell.corrected_with_seed_material = rows[cell.row].with_seed_material.at(cell.column);
  }
  const std::vector<RowValues> replayed = mapped(replay.nips, &ReplayedNip::values),
                               all_terms = mapped(rows, &CorrectedRow::all_terms),
                               exact_kernels = mapped(rows, &CorrectedRow::exact_kernels),
                               mesh = mapped(rows, &CorrectedRow::mesh),
                               no_mistake = mapped(rows, &CorrectedRow::no_mistake);
  const auto cost = [](const std::vector<RowValues>& wrong, const std::vector<RowValues>& right) {
    return deviations({"L", "d0", "p_max", "muR"}, wrong, right);
  };
  replay.costs = {
      {"stop", "the sum after the load has passed ended at its first small term, against all 500 terms",
       cost(replayed, all_terms)},
      {"truncation", "500 residue terms against exact kernels, same elements and load",
       cost(all_terms, exact_kernels)},
      {"discretisation", "line loads with exact kernels against the continuous contact of the same load",
       cost(exact_kernels, mesh)},
      {"exponent", "theta2 with e^(-2t/tau) against e^(-t/tau), continuous contacts of the same load",
       cost(mesh, no_mistake)}};
}

constexpr double elastic_accuracy = 1e-9;

RowValues converged_row(const data::ElasticNip& nip, data::Friction friction, double load) {
  return row_values(nip.sheet_thickness, fast::converged_for_load(nip, friction, load, elastic_accuracy));
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
