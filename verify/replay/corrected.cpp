#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/verify/replay/internal/half_space.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

constexpr double rolling_accuracy = 1e-6, elastic_accuracy = 1e-9;

RowValues continuous(const data::ViscoelasticNip& nip, double load) {
  return row_values(nip.sheet_thickness, fast::converged_for_load(nip, load, rolling_accuracy));
}

/// A weakness of the seed's method, and the two methods whose results are compared.
struct Weakness {
  const char *name, *against;
};

/// The results for one row, apart from its replay.
struct CorrectedRow {
  RowValues corrected;  ///< at the table's load
  std::optional<RowValues> with_seed_material;
  std::vector<RowValues>
      without;  ///< at the replay's load: without the first weakness, without the first two, and so on
};

/// Sets the corrected values of all cells, and the errors that each weakness causes in these columns.
void set_corrected(Replay& replay, std::initializer_list<const char*> columns,
                   std::initializer_list<Weakness> weaknesses,
                   const std::function<CorrectedRow(std::size_t row)>& correct_row) {
  const auto rows = parallel_mapped(replay.table.rows.size(), correct_row);
  for (ReplayedCell& cell : replay.cells) {
    cell.corrected = rows[cell.row].corrected.at(cell.column);
    if (const auto& other = rows[cell.row].with_seed_material)
      cell.corrected_with_seed_material = other->at(cell.column);
  }
  std::vector<RowValues> wrong = mapped(replay.nips, &ReplayedNip::values);
  for (const Weakness& weakness : weaknesses) {
    const auto right =
        mapped(rows, [&](const CorrectedRow& row) { return row.without[replay.costs.size()]; });
    replay.costs.push_back({weakness.name, weakness.against, deviations(columns, wrong, right)});
    wrong = right;
  }
}

/// Takes the continuous contact under the table's load, accurate to 1e-6, as the corrected value. Its solid is
/// defined as in the thesis, with one relaxation time in shear and dilatation. The second value has the thesis's theta2.
void correct_viscoelastic(Replay& replay, const ViscoelasticTable& how) {
  const auto correct_row = [&](std::size_t row) -> CorrectedRow {
    const auto defined = viscoelastic_nip_of_the_tables(replay.table, row, true);
    const auto printed = viscoelastic_nip_of_the_tables(replay.table, row, false);
    const double stated = replay.table.parameter("W").value, load = replay.nips[row].values.at("W");
    data::ViscoelasticLineLoads all_terms = viscoelastic_method(how);
    all_terms.trailing_elements = replay.nips[row].trailing_elements;
    all_terms.smallest_term = 0;
    data::ViscoelasticLineLoads exact_kernels = all_terms;
    exact_kernels.residue_terms = 0;
    const auto line_loads = [&](const data::ViscoelasticLineLoads& method) {
      return row_values(printed.sheet_thickness, fast::line_loads_for_load(printed, method, load));
    };
    return {continuous(defined, stated),
            continuous(printed, stated),
            {line_loads(all_terms), line_loads(exact_kernels), continuous(printed, load),
             continuous(defined, load)}};
  };
  set_corrected(
      replay, {"L", "d0", "p_max", "muR"},
      {{"stop", "the sum after the load has passed ended at its first small term, against all 500 terms"},
       {"truncation", "500 residue terms against exact kernels, same elements and load"},
       {"discretisation", "line loads with exact kernels against the continuous contact of the same load"},
       {"exponent", "theta2 with e^(-2t/tau) against e^(-t/tau), continuous contacts of the same load"}},
      correct_row);
}

void correct_elastic(Replay& replay) {
  const data::Friction friction = line_load_table(replay.table.id).friction;
  const data::ElasticNip nip = nip_of_the_tables(replay.table);
  const auto converged = [&](double load) {
    return row_values(nip.sheet_thickness, fast::converged_for_load(nip, friction, load, elastic_accuracy));
  };
  set_corrected(replay, {"L", "d0", "p_max"},
                {{"discretisation", "against the continuous contact of the same load"}},
                [&](std::size_t row) -> CorrectedRow {
                  return {converged(replay.table.cell(row, "W").number->value),
                          {},
                          {converged(replay.nips[row].values.at("W"))}};
                });
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
  if (item_with(half_space_tables(), &HalfSpaceTable::id, replay.table.id) != nullptr)
    return;  // its replay has the corrected values already
  replay.costs.clear();
  if (const ViscoelasticTable* const rolling = find_viscoelastic_table(replay.table.id))
    correct_viscoelastic(replay, *rolling);
  else
    correct_elastic(replay);
}

}  // namespace nipref::verify
