#include <vector>

#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/verify/replay/internal/viscoelastic_nip.hpp>
#include <nipref/verify/replay/internal/viscoelastic_row.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/internal/parallel.hpp>
#include <nipref/verify/support/mapped.hpp>

namespace nipref::verify {
namespace {

constexpr double accuracy = 1e-6;

RowValues continuous(const data::ViscoelasticNip& nip, double load) {
  const fast::ConvergedViscoelasticNip contact = fast::converged_for_load(nip, load, accuracy);
  return viscoelastic_row_values(
      nip, {contact.load().value, contact.leading_length().value, contact.trailing_length().value,
            contact.indentation().value, contact.peak_pressure().value, contact.creep_ratio().value,
            contact.rolling_resistance().value});
}

/// The results for one row besides its replay.
struct CorrectedRow {
  RowValues corrected, with_seed_material;    ///< at the table's load
  RowValues exact_kernels, mesh, no_mistake;  ///< at the replay's load
};

CorrectedRow correct_row(const Replay& replay, std::size_t row, const ViscoelasticTable& how) {
  const auto defined = viscoelastic_nip_of_the_tables(replay.table, row, true);
  const auto printed = viscoelastic_nip_of_the_tables(replay.table, row, false);
  const double stated = replay.table.parameter("W").value;
  fast::ViscoelasticLineLoadMethod method = viscoelastic_method(how);
  method.trailing_elements = replay.nips[row].trailing_elements;
  method.residue_terms = 0;
  CorrectedRow result;
  result.corrected = continuous(defined, stated);
  result.with_seed_material = continuous(printed, stated);
  const double load = replay.nips[row].values.at("W");
  result.exact_kernels =
      viscoelastic_row_values(printed, method, fast::viscoelastic_line_loads_for_load(printed, method, load));
  result.mesh = continuous(printed, load);
  result.no_mistake = continuous(defined, load);
  return result;
}

}  // namespace

void correct_viscoelastic(Replay& replay) {
  const ViscoelasticTable& how = *find_viscoelastic_table(replay.table.id);
  std::vector<CorrectedRow> rows(replay.table.rows.size());
  parallel_for(rows.size(), [&](std::size_t row) { rows[row] = correct_row(replay, row, how); });
  for (ReplayedCell& cell : replay.cells) {
    cell.corrected = rows[cell.row].corrected.at(cell.column);
    cell.corrected_with_seed_material = rows[cell.row].with_seed_material.at(cell.column);
  }
  const std::vector<RowValues> replayed = mapped(replay.nips, &ReplayedNip::values),
                               exact_kernels = mapped(rows, &CorrectedRow::exact_kernels),
                               mesh = mapped(rows, &CorrectedRow::mesh),
                               no_mistake = mapped(rows, &CorrectedRow::no_mistake);
  const auto cost = [](const std::vector<RowValues>& wrong, const std::vector<RowValues>& right) {
    return deviations({"L", "d0", "p_max", "muR"}, wrong, right);
  };
  replay.costs = {
      {"truncation", "500 residue terms against exact kernels, same elements and load",
       cost(replayed, exact_kernels)},
      {"discretisation", "line loads with exact kernels against the continuous contact of the same load",
       cost(exact_kernels, mesh)},
      {"exponent", "theta2 with e^(-2t/tau) against e^(-t/tau), continuous contacts of the same load",
       cost(mesh, no_mistake)}};
}

}  // namespace nipref::verify
