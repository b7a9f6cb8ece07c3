#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "data/bad_input.hpp"
#include "data/table_index.hpp"
#include "verify/render_tables.hpp"
#include "verify/replay.hpp"
#include "verify/replay_line_loads.hpp"
#include "verify/tables_verb.hpp"

using namespace nipref;
using verify::Verdict;

namespace {

data::TableCell cell(const std::string& printed, const std::string& read_as) {
  return {printed, read_as, data::read_printed_number(read_as, 0), std::nullopt};
}

}  // namespace

TEST_CASE("the matching rule: intervals meet or they do not") {
  const data::TableCell printed = cell("10.5", "10.5");  // [10.45, 10.55]
  CHECK(verify::judge(printed, {10.0, 11.0}) == Verdict::match);
  CHECK(verify::judge(printed, {10.54, 10.7}) == Verdict::match);
  CHECK(verify::judge(printed, {10.551, 10.7}) == Verdict::unexplained);
  CHECK(verify::judge(printed, {9.0, 10.449}) == Verdict::unexplained);
  CHECK(verify::judge(cell("70.5", "10.5"), {10.5, 10.5}) == Verdict::misprint);
  CHECK(verify::judge(cell("70.5", "10.5"), {70.5, 70.5}) == Verdict::unexplained);
  CHECK(verify::judge(cell("", ""), {10.5, 10.5}) == Verdict::unexplained);
}

TEST_CASE("Table VII: every cell that its own row does not contradict matches") {
  const verify::Replay replay = verify::replay_table("thesis-VII");
  CHECK(replay.count(Verdict::input) == 8);
  CHECK(replay.cells.size() == 72);
  for (const verify::ReplayedCell& replayed : replay.cells) {
    if (replayed.verdict == Verdict::input || replay.table.cell(replayed.row, "L").is_doubtful()) continue;
    CAPTURE(replayed.row);
    CAPTURE(replayed.column);
    CHECK(replayed.verdict == Verdict::match);
  }
}

TEST_CASE("one row of Table VII contradicts itself: L = 162.3 and L/B = 0.1624 with B = 1") {
  const data::Table table = data::load_table_by_id("thesis-VII");
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    CHECK(table.cell(row, "L").is_doubtful() == (row == 7));
  }
  CHECK(table.cell(7, "L").printed == "162.3");
  CHECK(table.cell(7, "L/B").printed == "0.1624");
}

TEST_CASE("a wrong number of elements does not reproduce the table") {
  const verify::Replay replay =
      verify::replay_frictionless_line_loads(data::load_table_by_id("thesis-VII"), 3);
  CHECK(replay.count(Verdict::match) < 30);
}

TEST_CASE("JSON of the replay has the shape that tools rely on") {
  const auto json = verify::tables_json({verify::replay_table("thesis-VII")});
  CHECK(json["tables"][0]["id"] == "thesis-VII");
  const auto& first = json["tables"][0]["cells"][1];
  CHECK(first["row"]["W"] == "25");
  CHECK(first["column"] == "d0");
  CHECK(first["printed"] == "342");
  CHECK(first["read_as"] == "342");
  CHECK(first["verdict"] == "match");
  const auto& summary = json["summary"];
  CHECK(summary["cells"] == 64);
  CHECK(summary["match"].get<int>() + summary["misprint"].get<int>() + summary["seed_error"].get<int>() +
            summary["unexplained"].get<int>() ==
        64);
}

TEST_CASE("tables verb: list, replay, refusal") {
  std::ostringstream list;
  CHECK(verify::tables_verb({.ids = {}, .list = true, .json = true, .compact = false}, list) == 0);
  const auto json = nlohmann::json::parse(list.str());
  CHECK(json["tables"].size() == 29);
  std::size_t rows = 0;
  for (const auto& table : json["tables"]) {
    if (table["id"].get<std::string>().starts_with("thesis")) rows += table["rows"].get<std::size_t>();
  }
  CHECK(rows == 224);
  std::ostringstream replay;
  CHECK(verify::tables_verb({.ids = {"thesis-VII"}, .list = false, .json = false, .compact = true}, replay) ==
        0);
  std::ostringstream nothing;
  CHECK_THROWS_AS(
      verify::tables_verb({.ids = {"thesis-C"}, .list = false, .json = false, .compact = false}, nothing),
      data::BadInput);
  CHECK(nothing.str().empty());
}
