// The replay of the viscoelastic tables: what the seed's mistakes explain, and the errors that they cause.
#include <nipref/data/table/index.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>

#include "support/replayed.hpp"

using namespace nipref;
using verify::Replay;
using verify::ReplayedCell;
using verify::Verdict;

TEST_CASE(
    "the thesis's printed lengths are cut: misses ask for longer ones, none for shorter ones, also where the row's other "
    "length reaches beyond") {
  std::size_t longer = 0, shorter = 0, longer_by_other = 0, shorter_by_other = 0;
  for (const verify::ViscoelasticTable& how : verify::viscoelastic_tables()) {
    const Replay& replay = replayed(std::string(how.id));
    for (std::size_t row = 0; row < replay.table.rows.size(); ++row) {
      const auto rolling = verify::viscoelastic_nip_of_the_tables(replay.table, row, false);
      auto method = verify::viscoelastic_method(how);
      const auto input = verify::viscoelastic_row_input(replay.table, row, rolling, method);
      method.trailing_elements = input.trailing_elements;
      const auto [low, high] = input.leading_length;
      const auto of_length = [&](const data::Interval& length) {
        return verify::replay_viscoelastic_row(rolling, method, length);
      };
      const auto meets = [&](const char* column, const auto& replayed_row) {
        const data::TableCell& cell = replay.table.cell(row, column);
        return !cell.is_doubtful() &&
               verify::assess(cell, replayed_row.range(column)) != Verdict::unexplained;
      };
      const auto here = of_length(input.leading_length);
      const auto meets_beyond = [&](const char* column, bool above) {
        const data::Interval length = above ? data::Interval{high, std::max(high, input.narrowest.upper)}
                                            : data::Interval{std::min(low, input.narrowest.lower), low};
        return length.upper > length.lower && meets(column, of_length(length));
      };
      for (const char* column : {"d0", "d1", "d2", "creep", "p_max", "muR"}) {
        if (meets(column, here)) continue;
        longer_by_other += meets_beyond(column, true) ? 1U : 0U;
        shorter_by_other += meets_beyond(column, false) ? 1U : 0U;
        if (column[0] != 'd') continue;
        longer += meets(column, of_length({high, high * (1 + 0x1p-20)})) ? 1U : 0U;
        shorter += meets(column, of_length({low * (1 - 0x1p-20), low})) ? 1U : 0U;
      }
    }
  }
  CHECK(longer == 12);
  CHECK(shorter == 0);
  CHECK(longer_by_other == 14);
  CHECK(shorter_by_other == 0);
}

TEST_CASE("where the thesis's last sum stopped is told by the even rows, and the odd rows confirm it") {
  // One table is tested by default. All five that have such rows are tested in .ci/thorough.
  std::vector<const char*> ids{"thesis-XXIV"};
  if (is_thorough()) ids.insert(ids.end(), {"thesis-XXI", "thesis-XXII", "thesis-XXV", "thesis-XXVI"});
  const auto misses = [&](double smallest_term) {
    std::array<std::size_t, 2> of_parity{};
    for (const char* id : ids) {
      verify::ViscoelasticTable how = *verify::find_viscoelastic_table(id);
      how.smallest_term = smallest_term;
      const Replay replay = verify::replay_viscoelastic(data::load_table_by_id(id), how);
      for (const ReplayedCell& cell : replay.cells) {
        if (cell.verdict == Verdict::unexplained && replay.table.cell(cell.row, cell.column).is_readable())
          ++of_parity[cell.row % 2];
      }
    }
    return of_parity;
  };
  const auto [even, odd] = misses(1e-8);
  for (const double other : {0.0, 0.5e-8, 2e-8}) {
    const auto [other_even, other_odd] = misses(other);
    MESSAGE(other, ": misses of even rows ", other_even, ", of odd rows ", other_odd, " beside ", even, ", ",
            odd);
    CHECK(even < other_even);
    CHECK(2 * odd < other_odd);
  }
}

TEST_CASE("corrected rolling tables tell what stop, truncation, mesh and exponent cost") {
  Replay replay = replayed("thesis-XI");
  REQUIRE(replay.nips.size() == replay.table.rows.size());
  for (const ReplayedCell& cell : replay.cells)
    CHECK(replay.nips[cell.row].values.at(cell.column) == cell.value);
  verify::correct(replay);
  REQUIRE(replay.costs.size() == 4);
  const auto largest = [&](std::size_t cost, std::size_t column) {
    return std::fabs(replay.costs[cost].columns[column].largest);
  };
  // For L, d0, p_max, muR the stop and the truncation cause the smallest errors, the mesh of two elements the largest.
  for (std::size_t column = 0; column < 4; ++column) {
    CHECK(largest(0, column) > 0);
    CHECK(largest(0, column) < 0.02);
    CHECK(largest(1, column) > 0);
    CHECK(largest(1, column) < 0.01);
    CHECK(largest(2, column) > largest(1, column));
  }
  CHECK(largest(0, 3) > 1e-3);
  CHECK(largest(3, 3) > 0.1);
  // The corrected value is for the table's load and for the solid as the thesis defines it.
  const auto solid = verify::viscoelastic_nip_of_the_tables(replay.table, 3, true);
  const auto contact = fast::converged_for_load(solid, 50, 1e-9);
  const ReplayedCell& d0 = cell_of(replay, 3, "d0");
  CHECK(*d0.corrected == approx(contact.indentation().value, 1e-6));
  CHECK(*d0.corrected_with_seed_material != approx(*d0.corrected, 1e-3));
}
