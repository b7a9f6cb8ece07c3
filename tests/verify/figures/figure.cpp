#include <nipref/data/directory.hpp>
#include <nipref/data/table/csv.hpp>
#include <nipref/data/table/table.hpp>
#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/replay/replay.hpp>

#include "support/run_nipref.hpp"
#include "support/table_rows.hpp"

namespace {

using namespace nipref;
using verify::Figure;
using verify::Series;

Figure figure(const std::string& id) {
  const auto plans = verify::figures();
  const auto plan = std::ranges::find(plans, id, &verify::FigurePlan::id);
  REQUIRE(plan != plans.end());
  return verify::compute(*plan);
}

/// A figure with fewer numbers in a list, each of which takes a contact. In .ci/thorough it has all of them.
Figure with_fewer(const std::string& id, const std::string& numbers, const std::string& fewer) {
  if (is_thorough()) return figure(id);
  const auto statements = data::statements_directory();
  const std::string all = text_of_file(statements / "figures.csv");
  REQUIRE(contains(all, numbers));
  const ScratchFolder folder;
  for (const char* const name : {"tables", "statements"})
    std::filesystem::create_directory(folder.file(name));
  std::filesystem::copy_file(statements / "drawings.toml", folder.file("statements/drawings.toml"));
  folder.write("statements/figures.csv", replaced_in(all, numbers, fewer));
  const Environment data("NIPREF_DATA", folder.path());
  return figure(id);
}

const Series& series_of(const verify::Panel& panel, const std::string& label, const std::string& role) {
  const auto found = std::ranges::find_if(
      panel.series, [&](const Series& one) { return one.label == label && one.role == role; });
  REQUIRE(found != panel.series.end());
  return *found;
}

/// The value of a curve at one of its places, up to rounding errors.
double at(const Series& curve, double x) {
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (std::fabs(curve.x[i] - x) <= 1e-12 * std::fabs(x)) return curve.y[i];
  }
  FAIL("the curve has no such place");
  return 0;
}

/// The series of one label in a panel, and the table whose column they show.
struct Drawn {
  std::string label, table, column, key;
};

void check_against_table(const verify::Panel& panel, const Drawn& drawn) {
  CAPTURE(drawn.label);
  verify::Replay replay = verify::replay_table(drawn.table);
  verify::correct(replay);
  const Series& curve = series_of(panel, drawn.label, "continuous contact");
  const Series& replayed = series_of(panel, drawn.label, "thesis's method");
  REQUIRE(replayed.y.size() == replay.table.rows.size());
  std::size_t cells = 0;
  for (const verify::ReplayedCell& cell : replay.cells) {
    if (cell.column != drawn.column) continue;
    CAPTURE(cell.row);
    ++cells;
    CHECK(replayed.y[cell.row] == cell.value);
    const double place = replay.table.cell(cell.row, drawn.key).number->value;
    CHECK(at(curve, place) == doctest::Approx(*cell.corrected).epsilon(2e-6));
  }
  CHECK(cells == replay.table.rows.size());
  const Series& printed = series_of(panel, drawn.label, "printed");
  CHECK(printed.x.size() > cells / 2);
  for (std::size_t i = 0; i < printed.x.size(); ++i) {
    CHECK(printed.low[i] <= printed.y[i]);
    CHECK(printed.y[i] <= printed.high[i]);
  }
}

/// The number of plots that draw a figure. A series of bars takes two.
std::size_t plots_of(const Figure& all) {
  std::size_t plots = 0;
  for (const verify::Panel& panel : all.panels) {
    std::set<std::string> labels, roles;
    for (const Series& series : panel.series) {
      labels.insert(series.label);
      roles.insert(series.role);
      plots += series.mark == verify::Mark::bars ? 2 : 1;
    }
    for (const std::size_t entries : {labels.size(), roles.size()}) plots += entries > 1 ? entries : 0;
  }
  return plots;
}

}  // namespace

TEST_CASE("all figures of the seeds that hold curves and those of Coulomb's friction are listed, each once") {
  std::vector<std::string> expected;
  for (const auto& [first, last] : {std::pair{7, 13}, {15, 15}, {17, 29}, {32, 38}, {41, 53}}) {
    for (int number = first; number <= last; ++number) expected.push_back("thesis-" + std::to_string(number));
  }
  for (const char* stresses : {"thesis-III-thick", "thesis-III-thin", "thesis-III-rolling"})
    expected.emplace_back(stresses);
  for (const char* other : {"brock2012-1", "brock2012-2", "brock2013-1", "brock2013-2", "brock2013-3",
                            "coulomb-creep", "coulomb-zones"})
    expected.emplace_back(other);
  std::vector<std::string> listed;
  for (const verify::FigurePlan& plan : verify::figures()) {
    listed.push_back(plan.id);
    CHECK_FALSE(plan.title.empty());
    CHECK_FALSE(plan.parameters.empty());
  }
  CHECK(listed == expected);
}

TEST_CASE("figures of elastic nips hold the replayed cells, and their curves pass the corrected ones") {
  check_against_table(figure("thesis-20").panels.front(), {"B = 0.005 in", "thesis-VI", "creep", "W"});
  check_against_table(figure("thesis-22").panels.front(), {"B = 0.25 in", "thesis-VIII", "L/B", "W"});
  const Figure limits = figure("thesis-25");
  check_against_table(limits.panels[0], {"no slip", "thesis-VI", "L", "W"});
  check_against_table(limits.panels[1], {"complete slip", "thesis-X", "d0", "W"});
}

TEST_CASE("figures of rolling nips hold the replayed cells, and their curves pass the corrected ones") {
  const verify::Panel panel = figure("thesis-51").panels.front();
  check_against_table(panel, {"B = 0.0625 in", "thesis-XX", "muR", "F0_tau"});
  for (const char* label : {"B = 1 in", "B = 0.25 in", "B = 0.0625 in", "B = 0.005 in"}) {
    CAPTURE(label);
    const Series& largest = series_of(panel, label, "largest");
    const double highest = std::ranges::max(series_of(panel, label, "continuous contact").y);
    CHECK(largest.y.front() >= highest * (1 - 1e-5));
    CHECK(largest.y.front() < 1.05 * highest);
  }
}

TEST_CASE("behind the papers' tables: the formula is as replayed, the rule's curve passes corrected cells") {
  const verify::Replay replay = verify::replay_table("brock2013-3");
  const verify::Panel panel = figure("brock2013-3").panels[1];
  for (const data::TableColumn& column : replay.table.columns) {
    if (column.is_key) continue;
    const std::string label = "c = " + column.name.substr(2);
    CAPTURE(label);
    for (const verify::ReplayedCell& cell : replay.cells) {
      if (cell.column != column.name) continue;
      const double phi = replay.table.cell(cell.row, "phi").number->value;
      CAPTURE(phi);
      CHECK(at(series_of(panel, label, "the table's formula"), phi) == cell.value);
      if (phi != std::floor(phi)) continue;  // the curve has whole degrees
      CHECK(at(series_of(panel, label, "the paper's rule, corrected"), phi) ==
            doctest::Approx(*cell.corrected).epsilon(1e-12));
      if (cell.exact)
        CHECK(at(series_of(panel, label, "exact ellipse, no friction"), phi) ==
              doctest::Approx(*cell.exact).epsilon(1e-9));
    }
  }
}

TEST_CASE("a contour's span along the motion is one, and it is closed") {
  for (const char* id : {"brock2012-1", "brock2013-3"}) {
    const Figure all = figure(id);
    for (const Series& contour : all.panels.front().series) {
      CAPTURE(contour.label);
      CHECK(contour.x.front() - contour.x[contour.x.size() / 2] == doctest::Approx(1));
      CHECK(contour.x.back() == doctest::Approx(contour.x.front()));
      CHECK(std::fabs(contour.y.back()) < 1e-12);
    }
  }
}

TEST_CASE("the printed solid creeps to 1.875 times its first strain, the defined one to twice it") {
  const verify::Panel panel = figure("thesis-32").panels.front();
  CHECK(series_of(panel, "theta1 + theta2", "solid as defined").y.back() == doctest::Approx(2).epsilon(2e-3));
  CHECK(series_of(panel, "theta1 + theta2", "solid as printed (6.29)").y.back() ==
        doctest::Approx(1.875).epsilon(2e-3));
}

TEST_CASE(
    "with Coulomb's friction creep falls as traction grows, and zones of slip shrink as friction grows") {
  const Figure creep =
      with_fewer("coulomb-creep", "-0.99 -0.95 evenly -0.9 0.9 13 0.95 0.99", "-0.99 -0.6 0 0.6 0.99");
  for (const verify::Panel& panel : creep.panels) {
    for (const Series& curve : panel.series) CHECK(std::ranges::is_sorted(curve.y, std::greater<>()));
  }
  // Bentall and Johnson's creep as friction goes to 0, -beta sqrt(1 - (c/a)^2)/2 with beta = 1/4 and c/a = 0.40397.
  CHECK(0.05 * at(creep.panels.front().series.front(), 0) == approx(-0.1143, 0.15));
  const Figure zones = with_fewer("coulomb-zones", "mu ratios 0.02 0.5 13", "mu 0.02 0.1 0.5");
  for (const verify::Panel& panel : zones.panels) {
    std::map<double, double> slip;  // length of slip over that of the contact, by friction
    for (const Series& bars : panel.series) {
      for (std::size_t i = 0; i < bars.x.size(); ++i) slip[bars.x[i]] += bars.high[i] - bars.low[i];
    }
    CHECK(slip.begin()->second > 0.2);
    CHECK(std::ranges::is_sorted(slip, std::greater<>(), [](const auto& one) { return one.second; }));
  }
  // A thick sheet's surface moves inwards, a thin one's outwards; friction opposes this where the sheet enters.
  CHECK(zones.panels.front().series[0].high.front() == 1);
  CHECK(zones.panels.back().series[1].high.front() == 1);
}

TEST_CASE("a figure's CSV has numbers everywhere") {
  // One figure of each kind. Figures of rolling sheets take seconds.
  const std::set<std::string> kinds{
      "thesis-7",  "thesis-9",    "thesis-11",   "thesis-12",        "thesis-13",  "thesis-15", "thesis-21",
      "thesis-26", "thesis-27",   "thesis-29",   "thesis-III-thick", "thesis-32",  "thesis-33", "thesis-36",
      "thesis-37", "brock2012-1", "brock2012-2", "brock2013-1",      "brock2013-2"};
  for (const verify::FigurePlan& plan : verify::figures()) {
    if (!kinds.contains(plan.id)) continue;
    CAPTURE(plan.id);
    const Figure all = verify::compute(plan);
    std::size_t points = 0;
    for (const verify::Panel& panel : all.panels) {
      for (const Series& series : panel.series) {
        CHECK_FALSE(series.x.empty());
        REQUIRE(series.y.size() == series.x.size());
        points += series.x.size();
      }
      if (panel.contours) {
        REQUIRE(panel.contours->values.size() == panel.contours->x.size() * panel.contours->y.size());
        points += panel.contours->values.size();
      }
    }
    const ScratchFile file(verify::figure_csv(all));
    const auto records = data::read_csv(file.path()).records;
    CHECK(verify::figure_csv(all).starts_with("panel,label,role,x,y,low,high,value\n"));
    CHECK(records.size() == 1 + points);
    for (std::size_t row = 1; row < records.size(); ++row) {
      // Only contours have the last column; apart from their place they have nothing else.
      const auto& fields = records[row];
      const bool of_contours = !fields.back().text.empty();
      for (std::size_t column = of_contours ? 7 : 3; column < (of_contours ? 8U : 7U); ++column) {
        CAPTURE(row, column, fields[column].text);
        CHECK(std::isfinite(data::read_exact_number(fields[column].text).value_or(infinite)));
      }
    }
  }
}

TEST_CASE("figures are drawn as SVG with all their series, where gnuplot is there") {
  if (std::system("command -v gnuplot >/dev/null") != 0) {
    MESSAGE("skipped: gnuplot is not installed");
    return;
  }
  for (const char* id : {"thesis-15", "thesis-28", "brock2013-3"}) {
    CAPTURE(id);
    const ScratchFile svg, csv;
    const Outcome outcome =
        run(std::string("figures ") + id + " --svg '" + svg.path() + "' --csv '" + csv.path() + "'");
    CHECK(outcome.status == 0);
    CHECK(outcome.out.starts_with(id));
    const Figure all = figure(id);
    CHECK(times_in(svg.text(), "<g id=\"gnuplot_plot_") == plots_of(all));
    CHECK(contains(svg.text(), all.parameters.substr(0, 20)));
    CHECK(csv.text() == verify::figure_csv(all));
  }
}
