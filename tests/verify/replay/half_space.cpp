// The replay of the tables of the two papers on half-spaces: the origin of each cell, and the correct values.
#include <nipref/data/table/index.hpp>
#include <nipref/fast/half_space/isotropic.hpp>
#include <nipref/verify/catalogue/internal/printed.hpp>
#include <nipref/verify/replay/internal/half_space.hpp>

#include "support/replayed.hpp"

using namespace nipref;
using doctest::Approx;
using verify::Replay;
using verify::ReplayedCell;
using verify::Verdict;

namespace {

/// nu = 1/3: mu = 1, lambda + 2 mu = 4.
const data::IsotropicSolid isotropic{1, 1.0 / 3, 1};

}  // namespace

TEST_CASE("the formulas as printed or tabulated fail where the right ones cannot") {
  const verify::GivenNumbers scaled{{"c11", 4}, {"c33", 4},   {"c13", 2}, {"c44", 1},
                                    {"c66", 1}, {"scale", 1}, {"c_D", 2}};
  const auto in_plane = [&](double sign) {
    return verify::printed("in_plane_compliance", {sign, std::cos(0.6), std::sin(0.6), 1, 0.5}, scaled);
  };
  const double right = fast::isotropic_response(isotropic, 0.5, {1, 0}).compliance;
  CHECK(right == Approx(0.83010914587).epsilon(1e-10));
  CHECK(in_plane(-1) == Approx(1.316).epsilon(1e-3));
  CHECK(in_plane(1) == Approx(0.0144).epsilon(1e-2));
  CHECK(verify::printed("sphere_compliance", {0.5}, scaled) == Approx(right).epsilon(1e-14));
  CHECK(verify::printed("rolling_span_ratio_printed", {1.0 / 3, 1e-3}) ==
        Approx(std::sqrt(2.0)).epsilon(1e-4));
  CHECK(verify::printed("branch_radicand_printed", {0.6 * 180 / std::numbers::pi},
                        {{"c11", 0.18}, {"c33", 2.08}, {"c13", 0.083}, {"c44", 0.0916}}) < 0);
  // Without friction the printed, the tabulated and the correct span of the die agree.
  const double die = fast::isotropic_response(isotropic, 0, {1, 0}).compliance / right;
  CHECK(verify::printed("die_span_ratio_printed", {1.0 / 3, 0, 0.5}) == Approx(die).epsilon(1e-12));
  CHECK(verify::printed("die_span_ratio_tabulated", {1.0 / 3, 0, 0.5, 0}) == Approx(die).epsilon(1e-12));
  CHECK(verify::printed("die_span_ratio_tabulated", {1.0 / 3, 0, 0.1, 5}) != Approx(die).epsilon(1e-4));
}

TEST_CASE("wrong formulas explain the cells of the die and the sphere, and symmetry proves others wrong") {
  const Replay& die = replayed("brock2012-1");
  for (const ReplayedCell& cell : die.cells) {
    CAPTURE(cell.row, cell.column);
    const double printed = die.table.cell(cell.row, cell.column).number->value;
    CHECK(std::fabs(cell.value - printed) < 1.0001e-4);
    CHECK(std::fabs(*cell.corrected - printed) > 4e-4);
  }
  for (const ReplayedCell& cell : replayed("brock2013-1").cells)
    CHECK(cell.value / *cell.corrected == Approx(0.533).epsilon(0.005));
  const Replay& in_plane = replayed("brock2013-3");
  for (const char* column : {"c=0.05", "c=0.1", "c=0.2", "c=0.3", "c=0.4"}) {
    const ReplayedCell& left = cell_of(in_plane, 8, column);
    const ReplayedCell& right = cell_of(in_plane, 0, column);
    CHECK(*left.corrected == Approx(*right.corrected).epsilon(1e-14));
    CHECK(*right.corrected < 1);
    CHECK(left.verdict == Verdict::seed_error);
    CHECK(contains(left.note, "must equal the " + in_plane.table.cell(0, column).printed));
  }
}

TEST_CASE("a cell matches the corrected value, or a formula or a proof explains it as the seed's error") {
  const data::Table die = data::load_table_by_id("brock2012-1");  // the first cell is 0.9938
  const auto verdict = [](const data::Table& table, std::size_t row, const char* column, double corrected,
                          double formula, const std::string& proof) {
    const verify::HalfSpaceCell cell{
        row, column, corrected, {{{formula, formula}, Verdict::seed_error, "so"}}, "E", proof};
    return verify::assess_half_space(table, cell).verdict;
  };
  CHECK(verdict(die, 0, "c=0.1", 0.9939, 0.5, "") == Verdict::match);
  CHECK(verdict(die, 0, "c=0.1", 0.99391, 0.5, "") == Verdict::unexplained);
  CHECK(verdict(die, 0, "c=0.1", 0.5, 0.9937, "") == Verdict::seed_error);
  CHECK(verdict(die, 0, "c=0.1", 0.5, 0.99369, "") == Verdict::unexplained);
  CHECK(verdict(die, 0, "c=0.1", 0.5, 0.99369, "P") == Verdict::seed_error);
  // The table itself marks this cell as doubtful, so that a proof that the formula is wrong does not explain it.
  const data::Table sphere = data::load_table_by_id("brock2013-1");
  CHECK(verdict(sphere, 2, "c=0.05", 0.5, 0.99369, "P") == Verdict::unexplained);
  // 1.21 is printed for 1.2100: two decimals do not admit the corrected value.
  const data::Table in_plane = data::load_table_by_id("brock2013-3");
  CHECK(verdict(in_plane, 5, "c=0.1", 1.206, 0.5, "") == Verdict::unexplained);
}
