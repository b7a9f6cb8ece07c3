#include <nipref/data/table/index.hpp>

#include "support/test.hpp"

// The tables as a whole: no table is missing, no table has lost a row, and the errata fit the tables.

using namespace nipref::data;

TEST_CASE("all tables of the seeds are there, in the order of the seeds") {
  const auto ids = table_ids();
  REQUIRE(ids.size() == 24 + 5);
  std::string all;
  for (const std::string& id : ids) all += id + " ";
  CHECK(
      all.starts_with("thesis-III thesis-IV thesis-V thesis-VI thesis-VII thesis-VIII thesis-IX thesis-X "));
  CHECK(all.ends_with(" thesis-XXVI brock2012-1 brock2012-2 brock2013-1 brock2013-2 brock2013-3 "));
}

TEST_CASE("a table is found by what stands behind its hyphen, or by its Arabic number") {
  for (const char* name : {"thesis-VII", "VII", "vii", "7", "Thesis-vii"})
    CHECK(find_table_id(name) == "thesis-VII");
  CHECK(find_table_id("III") == "thesis-III");
  CHECK(find_table_id("brock2013-3") == "brock2013-3");
  CHECK_REFUSED(find_table_id("3"), "table = 3: must be one of thesis-III, brock2013-3");
  CHECK_REFUSED(find_table_id("1"), "table = 1: must be one of brock2012-1, brock2013-1");
  CHECK_REFUSED(find_table_id("thesis-VIX"),
                "table = thesis-VIX: did you mean thesis-VI, thesis-VII or thesis-IX? must be an id that");
  CHECK_REFUSED(find_table_id(""), "table = : must be an id that 'tables --list' shows");
}

TEST_CASE("no row of the thesis and no cell of the Brock tables is missing") {
  std::size_t thesis_rows = 0;
  std::map<std::string, std::size_t> brock_cells;
  for (const auto& summary : summarize_tables()) {
    if (summary.id.starts_with("thesis-")) {
      thesis_rows += summary.rows;
    } else {
      CHECK(summary.empty == 0);
      brock_cells[summary.id] = summary.cells;
    }
  }
  CHECK(thesis_rows == 224);
  CHECK(brock_cells == std::map<std::string, std::size_t>{{"brock2012-1", 18},
                                                          {"brock2012-2", 6},
                                                          {"brock2013-1", 15},
                                                          {"brock2013-2", 15},
                                                          {"brock2013-3", 45}});
}

TEST_CASE("the row labels run as the text of the thesis says") {
  for (const auto& id : table_ids()) {
    const Table table = load_table_by_id(id);
    const std::string_view key = table.has_column("W") ? "W" : "F0_tau";
    if (!table.has_column(key)) continue;
    CAPTURE(id);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      const std::string expected =
          key == "W" ? std::to_string(25 * (row + 1)) : "1e" + std::to_string(3 - static_cast<int>(row));
      CHECK(table.cell(row, key).read_as == expected);
    }
  }
}

TEST_CASE("the span along the direction of sliding is the unit of its own ratio") {
  const Table table = load_table_by_id("brock2013-3");
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.cell(row, "phi").number->value != 0) continue;
    for (const auto& column : table.columns) {
      if (!column.is_key) CHECK(table.cell(row, column.name).number->value == 1);
    }
  }
}

TEST_CASE("a cell has no value only if its erratum says unreadable, and is empty only if it has an erratum") {
  for (const auto& id : table_ids()) {
    const Table table = load_table_by_id(id);
    for (const auto& row : table.rows) {
      for (const auto& cell : row) {
        CAPTURE(id, cell.printed);
        if (!cell.is_readable()) CHECK((cell.erratum && cell.erratum->kind == ErratumKind::unreadable));
        if (!cell.is_printed()) CHECK(cell.erratum.has_value());
      }
    }
  }
}

TEST_CASE("every erratum belongs to a table, and every one is found again in its cell") {
  const auto ids = table_ids();
  const auto errata = load_errata(tables_directory() / "errata.csv");
  std::size_t attached = 0;
  for (const auto& id : ids) {
    for (const auto& row : load_table_by_id(id).rows) {
      for (const TableCell& cell : row) attached += cell.erratum ? 1U : 0U;
    }
  }
  for (const auto& erratum : errata) {
    CAPTURE(erratum.table);
    CHECK(std::find(ids.begin(), ids.end(), erratum.table) != ids.end());
  }
  CHECK(attached == errata.size());
}

TEST_CASE("every known miss is a cell that has a number and is in no doubt") {
  const auto misses = load_known_misses(tables_directory() / "known_misses.csv");
  CHECK_FALSE(misses.empty());
  for (const KnownMiss& miss : misses) {
    CAPTURE(miss.table, miss.row, miss.column);
    const Table table = load_table_by_id(miss.table);
    const TableCell& cell = table.cell(miss.row - 1, miss.column);
    CHECK(cell.is_readable());
    CHECK_FALSE(table.columns[table.column_index(miss.column)].is_key);
  }
}

TEST_CASE("the summary counts each cell once") {
  for (const auto& summary : summarize_tables()) {
    CAPTURE(summary.id);
    CHECK(summary.cells == summary.rows * summary.columns);
    // Cells without a value are unreadable, and so are the doubtful ones; there are no others.
    CHECK(summary.without_value + summary.doubtful ==
          summary.errata[static_cast<std::size_t>(ErratumKind::unreadable)]);
  }
}

TEST_CASE("an id is looked up, never used as a path") {
  for (const char* id : {"thesis-I", "../tables/thesis-III", "errata", "known_misses"})
    CHECK_REFUSED(load_table_by_id(id), id);
}

TEST_CASE("what a table does not have is refused by name") {
  const Table table = load_table_by_id("thesis-VII");
  CHECK_REFUSED(table.cell(0, "q_max"), "column = q_max: must be a column of thesis-VII");
  CHECK_THROWS_AS((void)table.cell(8, "L"), BadInput);
  CHECK_THROWS_AS((void)table.parameter("W"), BadInput);
  CHECK(table.parameter("R").value == 6);
}
