// The replay of the viscoelastic tables: what is met, what the seed's mistakes explain, what they cost.
#include <nipref/data/table/index.hpp>
#include <nipref/data/table/known_misses.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>
#include <nipref/verify/replay/replay.hpp>

#include "support/replayed.hpp"
#include "support/test.hpp"

using namespace nipref;
using verify::Replay;
using verify::ReplayedCell;
using verify::Verdict;

namespace {

std::size_t legible(const Replay& replay) {
  return static_cast<std::size_t>(std::ranges::count_if(replay.cells, [&](const ReplayedCell& cell) {
    return cell.verdict != Verdict::input && replay.table.cell(cell.row, cell.column).is_readable();
  }));
}

const data::ViscoelasticNip nip{6, 0.25, {{1e-5, {{1e-4, 10.0}}}, {3e-6, {{6e-5, 20.0}}}}, 1};

}  // namespace

TEST_CASE(
    "Tables XI to XXVI, replayed once: 94 in 100 legible cells are met, and the known misses are misses, all of them "
    "and the only ones") {
  SUBCASE("Tables XI to XXVI: 94 in 100 legible cells are met, of each table 96 or more are explained") {
    struct Bound {
      std::string_view id;
      double explained;  // of its legible cells
    };
    std::size_t all_met = 0, all_legible = 0;
    for (const Bound& bound : {Bound{"thesis-XI", 0.99},
                               {"thesis-XII", 0.92},
                               {"thesis-XIII", 0.89},
                               {"thesis-XIV", 0.92},
                               {"thesis-XV", 0.94},
                               {"thesis-XVI", 0.95},
                               {"thesis-XVII", 0.94},
                               {"thesis-XVIII", 0.92},
                               {"thesis-XIX", 0.94},
                               {"thesis-XX", 0.95},
                               {"thesis-XXI", 0.93},
                               {"thesis-XXII", 0.91},
                               {"thesis-XXIII", 0.90},
                               {"thesis-XXIV", 0.91},
                               {"thesis-XXV", 0.84},
                               {"thesis-XXVI", 0.88}}) {
      CAPTURE(bound.id);
      const Replay& replay = replayed(std::string(bound.id));
      const std::size_t met = replay.count(Verdict::match) + replay.count(Verdict::misprint);
      const std::size_t explained = met + replay.count(Verdict::seed_error);
      CHECK(static_cast<double>(explained) >= bound.explained * static_cast<double>(legible(replay)));
      all_met += met;
      all_legible += legible(replay);
    }
    CHECK(static_cast<double>(all_met) >= 0.94 * static_cast<double>(all_legible));
  }
  SUBCASE("the viscoelastic tables are met from their printed lengths, one for each thickness") {
    for (const char* id : {"thesis-XIV", "thesis-XV", "thesis-XXII", "thesis-XXIV"}) {
      CAPTURE(id);
      const Replay& replay = replayed(id);
      const std::size_t met = replay.count(Verdict::match) + replay.count(Verdict::misprint);
      CHECK(static_cast<double>(met) >= 0.9 * static_cast<double>(legible(replay)));
      CHECK(static_cast<double>(met + replay.count(Verdict::seed_error)) >=
            0.94 * static_cast<double>(legible(replay)));
      for (const ReplayedCell& cell : replay.cells) {
        if (cell.verdict != Verdict::match) CHECK_FALSE(cell.note.empty());
      }
    }
  }
  SUBCASE("the notes' rows come out to their printed digits") {
    const Replay& replay = replayed("thesis-XV");
    CHECK(cell_of(replay, 5, "d0").value == approx(575.042e-6, 1e-5));
    CHECK(cell_of(replay, 5, "muR").value == approx(702.36e-6, 1e-5));
    CHECK(cell_of(replay, 5, "d0").verdict == Verdict::match);
    // m2 = 4 of m1 = 5 follows from the printed lengths.
    CHECK(cell_of(replay, 4, "L1").value / cell_of(replay, 4, "L2").value ==
          doctest::Approx(1.25).epsilon(1e-9));
  }
  SUBCASE("a row without a legible length is replayed from d2, one with a mended L1 meets its d2") {
    const Replay& replay = replayed("thesis-XII");
    for (std::size_t row = 5; row < 10; ++row) {
      CAPTURE(row);
      CHECK(replay.table.cell(row, "L1").is_readable() == false);
      CHECK(cell_of(replay, row, "d2").verdict == Verdict::input);
      CHECK(cell_of(replay, row, "d2").value == approx(replay.table.cell(row, "d2").number->value, 1e-9));
      CHECK(cell_of(replay, row, "d2/B").verdict == Verdict::misprint);
    }
    CHECK(cell_of(replay, 9, "muR").verdict == Verdict::match);
    CHECK(replay.table.cell(4, "L1").read_as == "77.402");
    CHECK(cell_of(replay, 4, "L1").value == approx(77.402e-3, 1e-9));
    CHECK(cell_of(replay, 4, "d2").verdict == Verdict::match);
  }
  SUBCASE("the creep of short relaxation times lacks what underflowed") {
    const Replay& replay = replayed("thesis-XXIV");
    const ReplayedCell& short_time = cell_of(replay, 8, "creep");
    CHECK(short_time.verdict == Verdict::seed_error);
    CHECK(contains(short_time.note, "underflows"));
    CHECK(cell_of(replay, 0, "creep").verdict == Verdict::match);
  }
  SUBCASE("the known misses are misses, all of them, and the only ones in the viscoelastic tables") {
    const auto misses = data::load_known_misses(data::tables_directory() / "known_misses.csv");
    std::size_t known = 0;
    for (const std::string& id : verify::replayable_tables()) {
      const verify::Replay& replay = replayed(id);
      for (const verify::ReplayedCell& replayed : replay.cells) {
        CAPTURE(id);
        CAPTURE(replayed.row);
        CAPTURE(replayed.column);
        const bool missed = replayed.verdict == Verdict::unexplained &&
                            replay.table.cell(replayed.row, replayed.column).is_readable();
        if (verify::find_viscoelastic_table(id) != nullptr)
          CHECK(verify::is_known_miss(misses, replay, replayed) == missed);
        if (!verify::is_known_miss(misses, replay, replayed)) continue;
        CHECK(replayed.verdict == Verdict::unexplained);
        ++known;
      }
    }
    CHECK(known == misses.size());
  }
}

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
      const auto meets = [&](const char* column, const data::Interval& length) {
        const data::TableCell& cell = replay.table.cell(row, column);
        return !cell.is_doubtful() &&
               verify::assess(cell, verify::replay_viscoelastic_row(rolling, method, length).range(column)) !=
                   Verdict::unexplained;
      };
      const auto meets_beyond = [&](const char* column, bool above) {
        const data::Interval length = above ? data::Interval{high, std::max(high, input.narrowest.upper)}
                                            : data::Interval{std::min(low, input.narrowest.lower), low};
        return length.upper > length.lower && meets(column, length);
      };
      for (const char* column : {"d0", "d1", "d2", "creep", "p_max", "muR"}) {
        if (meets(column, input.leading_length)) continue;
        longer_by_other += meets_beyond(column, true) ? 1U : 0U;
        shorter_by_other += meets_beyond(column, false) ? 1U : 0U;
        if (column[0] != 'd') continue;
        longer += meets(column, {high, high * (1 + 0x1p-20)}) ? 1U : 0U;
        shorter += meets(column, {low * (1 - 0x1p-20), low}) ? 1U : 0U;
      }
    }
  }
  CHECK(longer == 12);
  CHECK(shorter == 0);
  CHECK(longer_by_other == 14);
  CHECK(shorter_by_other == 0);
}

TEST_CASE("where the thesis's last sum stopped is told by the even rows, and the odd rows confirm it") {
  const auto misses = [](double smallest_term, std::size_t parity) {
    std::size_t sum = 0;
    for (const char* id : {"thesis-XXI", "thesis-XXII", "thesis-XXIV", "thesis-XXV", "thesis-XXVI"}) {
      verify::ViscoelasticTable how = *verify::find_viscoelastic_table(id);
      how.smallest_term = smallest_term;
      const Replay replay = verify::replay_viscoelastic(data::load_table_by_id(id), how);
      sum += static_cast<std::size_t>(std::ranges::count_if(replay.cells, [&](const ReplayedCell& cell) {
        return cell.verdict == Verdict::unexplained && cell.row % 2 == parity &&
               replay.table.cell(cell.row, cell.column).is_readable();
      }));
    }
    return sum;
  };
  const std::array<double, 4> candidates{0, 0.5e-8, 1e-8, 2e-8};
  std::array<std::size_t, 4> even{}, odd{};
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    even[i] = misses(candidates[i], 0);
    odd[i] = misses(candidates[i], 1);
    MESSAGE(candidates[i], ": misses of even rows ", even[i], ", of odd rows ", odd[i]);
  }
  for (const std::size_t other : {0U, 1U, 3U}) {
    CHECK(even[2] < even[other]);
    CHECK(2 * odd[2] < odd[other]);
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

TEST_CASE("rolling line loads with exact kernels and more elements approach the continuous contact") {
  const auto converged = fast::converged_for_load(nip, 50, 1e-9);
  const auto error = [&](int elements) {
    const auto found = fast::line_loads_for_load(nip, {elements, {}, 30, 0}, 50);
    return std::fabs(found.rolling_resistance() / converged.rolling_resistance().value - 1);
  };
  CHECK(error(40) < 0.5 * error(10));
  CHECK(error(40) < 0.05);
}
