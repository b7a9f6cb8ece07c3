// The replay of all tables: what is met, what the seed's mistakes explain, and, of rolling nips, what they cost.
#include <nipref/data/table/index.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>

#include "support/replayed.hpp"
#include "support/table_rows.hpp"

using namespace nipref;
using verify::Replay;
using verify::ReplayedCell;
using verify::Verdict;

namespace {

/// A line of cells.txt.
void check_known(const std::vector<std::string>& row) {
  const Replay& replay = replayed(row.at(0));
  std::istringstream place(row.at(1));
  std::size_t number = 0;
  std::string column;
  const bool is_of_cell = static_cast<bool>(place >> number >> column);
  for (const std::string& claim : std::span(row).subspan(2)) {
    CAPTURE(row[0], row[1], claim);
    const std::string kind = claim.substr(0, claim.find(' ')), what = claim.substr(kind.size() + 1);
    if (!is_of_cell) {
      const auto verdict = std::ranges::find(verify::verdict_names, kind) - verify::verdict_names.begin();
      CHECK(replay.count(static_cast<Verdict>(verdict)) == std::stoul(what));
      continue;
    }
    const ReplayedCell& cell = cell_of(replay, number - 1, column);
    const std::map<std::string, std::optional<double>> numbers{
        {"value", cell.value}, {"corrected", cell.corrected}, {"exact", cell.exact}};
    if (kind == "is") {
      CHECK(verify::name(cell.verdict) == what);
    } else if (kind == "says") {
      CHECK(contains(cell.note, what));
    } else if (kind == "reads") {
      CHECK(replay.table.cell(cell.row, column).read_as == what);
    } else if (what == "none") {
      CHECK_FALSE(numbers.at(kind));
    } else {
      CHECK(numbers.at(kind).value() ==
            approx(std::stod(what), std::stod(what.substr(what.find(" +- ") + 4))));
    }
  }
}

}  // namespace

TEST_CASE("all tables, replayed once: what is known of them, and what is not met says why") {
  SUBCASE("cells that are known one by one") {
    const auto rows = table_rows("verify/replay/cells.txt");
    CHECK(rows.size() > 50);
    for (const auto& row : rows) check_known(row);
  }
  SUBCASE("each cell that is not met says why, and the known misses are missed, of rolling nips no others") {
    const auto misses = data::load_known_misses(data::tables_directory() / "known_misses.csv");
    std::size_t known = 0, judged = 0;
    for (const std::string& id : verify::replayable_tables()) {
      const Replay& replay = replayed(id);
      for (const ReplayedCell& cell : replay.cells) {
        CAPTURE(id, cell.row, cell.column);
        const data::TableCell& printed = replay.table.cell(cell.row, cell.column);
        const bool is_known = verify::is_known_miss(misses, replay, cell),
                   is_missed = cell.verdict == Verdict::unexplained;
        if (cell.verdict != Verdict::match && cell.verdict != Verdict::input) CHECK_FALSE(cell.note.empty());
        if (is_known) CHECK(is_missed);
        known += is_known ? 1 : 0;
        if (verify::find_viscoelastic_table(id) != nullptr)
          CHECK(is_known == (is_missed && printed.is_readable()));
        if (id.starts_with("brock"))
          CHECK((cell.corrected && (!is_missed || is_known || printed.is_doubtful())));
        if (!printed.rests_on_replay()) continue;
        // Of no reading that rests on the replay is the chance below 1 %.
        CHECK(cell.verdict != Verdict::misprint);
        CHECK(contains(cell.note, "by chance in"));
        ++judged;
      }
    }
    CHECK(known == misses.size());
    CHECK(judged == 10);
  }
  SUBCASE("95 in 100 cells of Tables III to X are explained, 94 in 100 legible ones of XI to XXVI are met") {
    for (const bool rolls : {false, true}) {
      double cells = 0, met = 0, seed_errors = 0, legible = 0;
      for (const std::string& id : verify::replayable_tables()) {
        if (!id.starts_with("thesis") || (verify::find_viscoelastic_table(id) != nullptr) != rolls) continue;
        const Replay& replay = replayed(id);
        for (const ReplayedCell& cell : replay.cells) {
          if (cell.verdict == Verdict::input) continue;
          ++cells;
          met += cell.verdict == Verdict::match || cell.verdict == Verdict::misprint ? 1 : 0;
          seed_errors += cell.verdict == Verdict::seed_error ? 1 : 0;
          legible += replay.table.cell(cell.row, cell.column).is_readable() ? 1 : 0;
        }
      }
      CHECK(met >= (rolls ? 0.94 : 0.92) * legible);
      if (rolls) continue;
      CHECK(met + seed_errors >= 0.95 * cells);
      CHECK(legible > 0.98 * cells);
    }
  }
  SUBCASE("rows of rolling nips without a legible length are replayed from d2, and m2 follows from lengths") {
    const Replay& replay = replayed("thesis-XII");
    for (std::size_t row = 5; row < 10; ++row) {
      CHECK_FALSE(replay.table.cell(row, "L1").is_readable());
      CHECK(cell_of(replay, row, "d2").value == approx(replay.table.cell(row, "d2").number->value, 1e-9));
    }
    const Replay& fifteen = replayed("thesis-XV");  // m2 = 4 of m1 = 5
    CHECK(cell_of(fifteen, 4, "L1").value / cell_of(fifteen, 4, "L2").value == approx(1.25, 1e-9));
  }
  SUBCASE(
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
}

TEST_CASE("where the thesis's last sum stopped is told by the even rows, and the odd rows confirm it") {
  // One of the tables tells it by day, all five that have such rows in .ci/thorough.
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

TEST_CASE("corrected rolling tables: what stop, truncation, mesh and exponent cost") {
  Replay replay = replayed("thesis-XI");
  REQUIRE(replay.nips.size() == replay.table.rows.size());
  for (const ReplayedCell& cell : replay.cells)
    CHECK(replay.nips[cell.row].values.at(cell.column) == cell.value);
  verify::correct(replay);
  REQUIRE(replay.costs.size() == 4);
  const auto largest = [&](std::size_t cost, std::size_t column) {
    return std::fabs(replay.costs[cost].columns[column].largest);
  };
  // L, d0, p_max, muR: the stop and the truncation are the smallest evils, the mesh of two elements the greatest.
  for (std::size_t column = 0; column < 4; ++column) {
    CHECK(largest(0, column) > 0);
    CHECK(largest(0, column) < 0.02);
    CHECK(largest(1, column) > 0);
    CHECK(largest(1, column) < 0.01);
    CHECK(largest(2, column) > largest(1, column));
  }
  CHECK(largest(0, 3) > 1e-3);
  CHECK(largest(3, 3) > 0.1);
  // The corrected value carries the table's load with the solid as it was defined.
  const auto solid = verify::viscoelastic_nip_of_the_tables(replay.table, 3, true);
  const auto contact = fast::converged_for_load(solid, 50, 1e-9);
  const ReplayedCell& d0 = cell_of(replay, 3, "d0");
  CHECK(*d0.corrected == approx(contact.indentation().value, 1e-6));
  CHECK(*d0.corrected_with_seed_material != approx(*d0.corrected, 1e-3));
}
