#include <nipref/data/table/index.hpp>

#include "support/test.hpp"

// The redundancy of the thesis's tables, identity by identity: each is an equation between the cells of a
// row, and the rounding intervals of the cells have to admit it.

using namespace nipref::data;

namespace {

Interval operator+(Interval a, Interval b) { return {a.lower + b.lower, a.upper + b.upper}; }
Interval operator-(Interval a, Interval b) { return {a.lower - b.upper, a.upper - b.lower}; }
// Only positive quantities are multiplied here.
Interval operator*(Interval a, Interval b) { return {a.lower * b.lower, a.upper * b.upper}; }

/// One equation: the columns that enter, and its right side minus its left side.
struct Identity {
  std::string name;
  std::vector<std::string> columns;
  std::function<Interval(const std::vector<Interval>&)> defect;
};

Identity ratio_to_thickness(const std::string& column, double thickness) {
  return {column + "/B", {column, column + "/B"}, [thickness](const auto& cell) {
            return cell[1] * Interval{thickness, thickness} - cell[0];
          }};
}

Identity ratio_to_indentation(const std::string& column) {
  return {column + "/d0", {column, "d0", column + "/d0"}, [](const auto& cell) {
            return cell[2] * cell[1] - cell[0];
          }};
}

/// The roller's parabola: what lies `length` from its lowest point is length^2 / (2 R) higher. `share` is the
/// part of the length column that counts.
Identity parabola(const std::string& length, double share, const std::string& end, double radius) {
  const double factor = share * share / (2 * radius);
  return {"d0 - " + end, {length, "d0", end}, [factor](const auto& cell) {
            return cell[0] * cell[0] * Interval{factor, factor} - (cell[1] - cell[2]);
          }};
}

std::vector<Identity> identities_of(const Table& table) {
  const double thickness = table.parameter("B").value;
  const double radius = table.parameter("R").value;
  std::vector<Identity> identities;
  if (table.has_column("L1")) {
    identities.push_back(
        {"L = L1 + L2", {"L1", "L2", "L"}, [](const auto& cell) { return cell[0] + cell[1] - cell[2]; }});
    identities.push_back(parabola("L1", 1, "d1", radius));
    identities.push_back(parabola("L2", 1, "d2", radius));
    identities.push_back(ratio_to_thickness("d2", thickness));
    identities.push_back(ratio_to_indentation("d2"));
  } else {
    identities.push_back(parabola("L", 0.5, "d1", radius));
  }
  for (const char* const column : {"L", "d0", "d1"})
    identities.push_back(ratio_to_thickness(column, thickness));
  identities.push_back(ratio_to_indentation("d1"));
  return identities;
}

/// What became of the identities of all rows.
struct Tally {
  std::size_t tested = 0;
  std::size_t without_value = 0;  // a cell that enters cannot be read
  std::size_t doubtful = 0;       // a cell that enters is listed as contradicted
  std::set<std::pair<std::string, std::size_t>> touched;
};

bool any_cell(const Table& table, std::size_t row, const Identity& identity,
              bool (TableCell::*property)() const) {
  return std::any_of(identity.columns.begin(), identity.columns.end(),
                     [&](const auto& column) { return (table.cell(row, column).*property)(); });
}

bool all_readable(const Table& table, std::size_t row, const Identity& identity) {
  return std::all_of(identity.columns.begin(), identity.columns.end(),
                     [&](const auto& column) { return table.cell(row, column).is_readable(); });
}

void test_identity(const Table& table, std::size_t row, const Identity& identity, Tally& tally) {
  if (!all_readable(table, row, identity)) {
    ++tally.without_value;
    return;
  }
  if (any_cell(table, row, identity, &TableCell::is_doubtful)) {
    ++tally.doubtful;
    return;
  }
  std::vector<Interval> cells;
  for (const auto& column : identity.columns) {
    cells.push_back(table.cell(row, column).number->rounding);
    tally.touched.emplace(table.id + '/' + column, row);
  }
  const Interval defect = identity.defect(cells);
  // The evaluation's own rounding, a few units in the last place of the largest term.
  const double slack = 1e-14 * std::max(1e-3, cells.front().upper);
  CAPTURE(table.id);
  CAPTURE(row + 1);
  CAPTURE(identity.name);
  CHECK(defect.lower <= slack);
  CHECK(defect.upper >= -slack);
  ++tally.tested;
}

}  // namespace

TEST_CASE("every identity holds in every row of the thesis's tables") {
  Tally tally;
  std::size_t expected = 0;
  std::size_t cells = 0;
  for (const auto& summary : summarize_tables()) {
    if (!summary.id.starts_with("thesis-")) continue;
    const Table table = load_table_by_id(summary.id);
    const auto identities = identities_of(table);
    cells += summary.cells;
    expected += identities.size() * table.rows.size();
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      for (const auto& identity : identities) test_identity(table, row, identity, tally);
    }
  }
  CHECK(expected == 8 * 8 * 5 + 16 * 10 * 9);
  CHECK(tally.tested + tally.without_value + tally.doubtful == expected);
  MESSAGE("identities: ", expected, ", tested: ", tally.tested,
          ", with a cell without value: ", tally.without_value, ", with a doubtful cell: ", tally.doubtful);
  MESSAGE("cells that entered a test: ", tally.touched.size(), " of ", cells,
          "; creep, p_max, q_max and muR enter no identity");
}
