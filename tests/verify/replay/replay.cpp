#include <nlohmann/json.hpp>

#include <nipref/data/directory.hpp>
#include <nipref/data/table/index.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/line_loads.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>
#include <nipref/verify/replay/internal/readings.hpp>

#include "support/replayed.hpp"
#include "support/table_rows.hpp"

using namespace nipref;
using verify::Replay;
using verify::ReplayedCell;
using verify::Verdict;

namespace {

data::TableCell cell(const std::string& printed, const std::string& read_as) {
  return {printed, read_as, data::read_printed_number(read_as, 0), std::nullopt};
}

/// Checks a line of cells.txt.
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

TEST_CASE("a cell matches if the interval of its printed digits meets that of its replay") {
  const data::TableCell printed = cell("10.5", "10.5");  // [10.45, 10.55]
  CHECK(verify::assess(printed, {10.0, 11.0}) == Verdict::match);
  CHECK(verify::assess(printed, {10.54, 10.7}) == Verdict::match);
  CHECK(verify::assess(printed, {10.551, 10.7}) == Verdict::unexplained);
  CHECK(verify::assess(printed, {9.0, 10.449}) == Verdict::unexplained);
  CHECK(verify::assess(cell("70.5", "10.5"), {10.5, 10.5}) == Verdict::misprint);
  CHECK(verify::assess(cell("70.5", "10.5"), {70.5, 70.5}) == Verdict::unexplained);
  CHECK(verify::assess(cell("", ""), {10.5, 10.5}) == Verdict::unexplained);
  CHECK(verify::assess(cell("10", "10.?"), {10.94, 11}) == Verdict::match);  // [9.95, 10.95]
  CHECK(verify::assess(cell("10", "10.?"), {10.96, 11}) == Verdict::unexplained);
}

TEST_CASE("all tables are replayed as is known of them, and what is not met says why") {
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
        // No reading that rests on the replay has a chance below 1 %.
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
}

TEST_CASE("columns agree on a length by chance: X, row 8, in 2 of 1000 rows, VII, row 8, in 18 of 100") {
  struct Length {
    const char* id;
    double chance, upper;  // upper: above the lengths that the columns give
  };
  for (const auto& [id, chance, upper] :
       {Length{"thesis-X", 0.0018, 48.55e-3}, Length{"thesis-VII", 0.18, 162.4e-3}}) {
    CAPTURE(id);
    const data::Table table = data::load_table_by_id(id);
    const data::ElasticNip nip = verify::nip_of_the_tables(table);
    const int elements = verify::line_load_table(id).elements_per_side;
    const auto witnesses =
        verify::witnesses_of_length(table, 7, table.cell(7, "L").number->rounding, [&](double length) {
          return verify::row_values(nip.sheet_thickness, fast::line_loads_for_length(nip, elements, length));
        });
    CHECK(witnesses.size() == 3);
    for (const verify::LengthWitness& witness : witnesses) CHECK(witness.length.upper < upper);
    CHECK(verify::chance_of_agreement(witnesses, 0.1e-3) == doctest::Approx(chance).epsilon(0.15));
  }
  CHECK(verify::chance_of_agreement({{"a", {0, 0.1}}, {"b", {0.2, 0.3}}}, 1) == 1);
  CHECK(verify::chance_of_agreement({{"a", {0, 0.1}}, {"b", {0, 0.2}}}, 1) == doctest::Approx(0.3));
}

TEST_CASE("XVII, rows 6 to 9: at the lengths that d2 demands d0 is met within three machine units") {
  data::Table table = data::load_table_by_id("thesis-XVII");
  constexpr double machine_unit = 0x1p-32;  // of d0, which is between 16^-3 and 16^-2: 2.3e-10
  const auto d0 = [&](std::size_t row) {
    const verify::ViscoelasticTable& how = *verify::find_viscoelastic_table(table.id);
    for (const char* length : {"L1", "L", "L2", "L/B"})
      table.rows[row][table.column_index(length)].number = {};
    const data::ViscoelasticNip nip = verify::viscoelastic_nip_of_the_tables(table, row, false);
    auto method = verify::viscoelastic_method(how);
    const verify::ViscoelasticRowInput input = verify::viscoelastic_row_input(table, row, nip, method);
    CHECK(input.column == "d2");  // d1 = d2
    method.trailing_elements = input.trailing_elements;
    return verify::replay_viscoelastic_row(nip, method, input.leading_length).range("d0");
  };
  for (const std::size_t row : {5u, 6u, 7u, 8u}) {
    CAPTURE(row);
    const data::Interval found = d0(row);
    CHECK(table.cell(row, "d0").number->rounding.meets({found.lower - 3 * machine_unit, found.upper}));
    CHECK(table.cell(row, "d0").number->rounding.meets(found) == (row == 7));
  }
  CHECK_FALSE(d0(8).meets(table.cell(7, "d0").number->rounding));
}

TEST_CASE("another digit is a misprint or a likely one by the chance of its meeting the replay") {
  const data::Table table = data::load_table_by_id("thesis-III");
  const auto verdict = [&](const data::Interval& range) {
    verify::ReplayedCell cell{2, "p_max", range.middle(), range, Verdict::unexplained, ""};  // 844.185
    verify::judge_reading(table, cell, range);
    return cell.verdict;
  };
  CHECK(verdict({848.182, 848.185}) == Verdict::misprint);         // 0.004 of 1
  CHECK(verdict({848.170, 848.185}) == Verdict::likely_misprint);  // 0.016 of 1
  CHECK(verdict({848.000, 848.250}) == Verdict::unexplained);      // 0.251 of 1
  CHECK(verdict({844.187, 844.187}) == Verdict::unexplained);      // a last digit always can be met
  CHECK(verdict({848.1834, 848.1844}) == Verdict::unexplained);    // meets none
  CHECK(verdict({744.1852, 744.1853}) == Verdict::misprint);
}

TEST_CASE("a wrong number of elements does not reproduce the table") {
  const verify::Replay replay =
      verify::replay_line_loads(data::load_table_by_id("thesis-VII"), data::Friction::none, 3);
  CHECK(replay.count(Verdict::match) < 30);
}

TEST_CASE("the printed creep of Table III is rounded away from zero, and of no other") {
  for (const std::string id : {"thesis-III", "thesis-IV", "thesis-V", "thesis-VI"}) {
    const verify::Replay& replay = replayed(id);
    CAPTURE(id);
    const auto is_so = [](const verify::ReplayedCell& cell) {
      return cell.verdict == Verdict::seed_error && contains(cell.note, "rounded away from zero");
    };
    CHECK(std::ranges::any_of(replay.cells, is_so) == (id == "thesis-III"));
  }
  // One corrected number explains d0, d1, q_max and their ratios of a row.
  const verify::Replay& third = replayed("thesis-III");
  for (const verify::ReplayedCell& replayed : third.cells) {
    if (replayed.row != 5 || replayed.verdict == Verdict::input) continue;
    CHECK(replayed.verdict != Verdict::unexplained);
  }
}

TEST_CASE("corrected cells are the continuous contact's, of whose length thick sheets lack a sixth") {
  verify::Replay replay = replayed("thesis-VII");
  verify::correct(replay);
  const data::ElasticNip nip = verify::nip_of_the_tables(replay.table);
  const auto truth = fast::converged_for_load(nip, data::Friction::none, 25.0, 1e-10);
  for (const verify::ReplayedCell& replayed : replay.cells) REQUIRE(replayed.corrected);
  for (const auto& [column, value] :
       {std::pair{"L", truth.contact_length().value},
        {"creep", truth.creep_ratio().value},
        {"d1/d0", truth.leading_displacement().value / truth.indentation().value}})
    CHECK(*cell_of(replay, 0, column).corrected == approx(value, 1e-7));
  REQUIRE(replay.costs.size() == 1);
  REQUIRE(replay.costs[0].columns.size() == 3);
  const verify::ColumnDeviation& length = replay.costs[0].columns[0];
  CHECK(length.column == "L");
  CHECK(length.largest < 0);
  CHECK(length.mean > 0.14);  // 15 % of the thesis's own length or more
  CHECK(length.mean < 0.19);
  const std::string text = verify::text_of("tables.txt", verify::tables_json({replay}, true));
  CHECK(contains(text, "discretisation (against the continuous contact of the same load)"));
}

TEST_CASE("what the mesh costs is measured from the rows as they were replayed, none once more") {
  verify::Replay replay = replayed("thesis-VII");
  REQUIRE(replay.nips.size() == replay.table.rows.size());
  for (const verify::ReplayedCell& cell : replay.cells)
    CHECK(replay.nips[cell.row].values.at(cell.column) == cell.value);
  // If the rows were replayed again, the depths that are deleted here would come back.
  for (verify::ReplayedNip& nip : replay.nips) nip.values["d0"] = 0;
  verify::correct(replay);
  const verify::ColumnDeviation& depth = replay.costs[0].columns[1];
  CHECK(depth.column == "d0");
  CHECK(depth.mean == doctest::Approx(1).epsilon(1e-12));
  CHECK(depth.largest == -1);
}

TEST_CASE("every cell with full friction is corrected, its creep to another than the replayed one") {
  verify::Replay replay = replayed("thesis-IV");
  verify::correct(replay);
  const auto json = nlohmann::json::parse(verify::tables_json({replay}).text());
  bool differs = false;
  for (const auto& cell : json["tables"][0]["cells"]) {
    CHECK(cell["corrected"].is_number());
    if (cell["column"] == "creep") differs = differs || cell["corrected"] != cell["replayed"];
  }
  CHECK(differs);
  CHECK(json["tables"][0]["costs"]["discretisation"]["p_max"]["mean"].get<double>() > 0);
}
