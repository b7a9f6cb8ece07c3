#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include <nipref/verify/figures/render.hpp>
#include <nipref/verify/report/internal/counts.hpp>
#include <nipref/verify/report/internal/sections.hpp>
#include <nipref/verify/support/internal/or_dash.hpp>

namespace nipref::verify {
namespace {

constexpr std::size_t fewest_ways = 4;  ///< to the same values, that make a plot
constexpr double least_drawn_error = 1e-17;

/// Ways to the same values.
struct TimedGroup {
  std::string quantity, arguments;
  std::vector<const BenchRow*> rows;

  [[nodiscard]] std::size_t drawn() const {
    return static_cast<std::size_t>(std::ranges::count_if(rows, [](const BenchRow* row) {
      return row->max_relative_error && std::isfinite(*row->max_relative_error);
    }));
  }
};

std::vector<TimedGroup> timed_groups(const std::vector<BenchRow>& rows) {
  std::vector<TimedGroup> groups;
  for (const BenchRow& row : rows) {
    const auto known = std::ranges::find_if(groups, [&](const TimedGroup& group) {
      return group.quantity == row.quantity && group.arguments == row.arguments;
    });
    if (known == groups.end()) {
      groups.push_back({row.quantity, row.arguments, {&row}});
    } else {
      known->rows.push_back(&row);
    }
  }
  return groups;
}

/// A method without its accuracy: "fast batch" of "fast batch rtol=1e-06".
std::string family_of(const std::string& method) {
  std::istringstream words(method);
  std::string family;
  for (std::string word; words >> word && word != "full";) {
    if (std::ranges::any_of(word, [](unsigned char letter) { return std::isdigit(letter) != 0; })) break;
    family += (family.empty() ? "" : " ") + word;
  }
  while (family.ends_with(':') || family.ends_with(',')) family.pop_back();
  return family.empty() ? method : family;
}

void append_way(Series& series, const BenchRow& row) {
  series.x.push_back(std::max(*row.max_relative_error, least_drawn_error));
  series.y.push_back(row.nanoseconds);
  if (series.mark != Mark::bars) return;
  series.low.push_back(row.quartile_1 > 0 ? row.quartile_1 : row.nanoseconds);
  series.high.push_back(row.quartile_3 > 0 ? row.quartile_3 : row.nanoseconds);
}

Panel speed_panel(const TimedGroup& group) {
  Panel panel{{"largest error, relative", true}, {"time of a value, ns", true}, {}};
  Series best{"none better in this run", "none better in this run", Mark::star, {}, {}};
  for (const BenchRow* row : group.rows) {
    if (!row->max_relative_error || !std::isfinite(*row->max_relative_error)) continue;
    const std::string family = family_of(row->method);
    auto series = std::ranges::find(panel.series, family, &Series::label);
    if (series == panel.series.end()) {
      panel.series.push_back({family, family, Mark::bars, {}, {}});
      series = panel.series.end() - 1;
    }
    append_way(*series, *row);
    if (row->pareto_optimal) append_way(best, *row);
  }
  if (!best.x.empty()) panel.series.push_back(best);
  return panel;
}

TableMarkup speed_table(const std::string& caption, bool with_names) {
  std::vector<std::string> headings{"method",
                                    "none better",
                                    "#time, ns",
                                    "#largest error, relative",
                                    "#in ulp",
                                    "#time over fast or ref",
                                    "#quarters of the rounds, ns"};
  if (with_names) headings.insert(headings.begin(), {"quantity", "arguments"});
  return {caption, headings};
}

void append_timed_row(TableMarkup& table, const BenchRow& row, bool with_names) {
  std::vector<TableCellMarkup> cells{
      {row.method, false, "keep"},
      {row.pareto_optimal ? "\u2605 yes" : ""},
      number_cell(fmt::format("{:.4g}", row.nanoseconds)),
      number_cell(or_dash(row.max_relative_error, 2)),
      number_cell(or_dash(row.max_error_ulp, 3)),
      number_cell(or_dash(row.ratio, 3)),
      number_cell(row.quartile_3 > 0 ? fmt::format("{:.4g} to {:.4g}", row.quartile_1, row.quartile_3)
                                     : "-")};
  if (with_names) cells.insert(cells.begin(), {{row.quantity}, {row.arguments}});
  table.row(cells);
}

Markup speed_group(const TimedGroup& group, Plots& plots) {
  const std::string title = group.quantity + ", " + group.arguments;
  TableMarkup table = speed_table("Ways to the same values", false);
  std::size_t undrawn = 0;
  for (const BenchRow* row : group.rows) {
    append_timed_row(table, *row, false);
    undrawn += !row->max_relative_error || !std::isfinite(*row->max_relative_error);
  }
  const std::string note =
      undrawn == 0 ? "" : fmt::format(" {} ways without an error known are in the table only.", undrawn);
  return element(
      "div", {{"class", "beside"}},
      element("figure", plots.place(gnuplot_script(speed_panel(group)),
                                    "Time of a value against its largest relative error, " + title +
                                        ". The numbers are in the table beside it.") +
                            element("figcaption", "Lower is quicker, to the left is more right." + note)) +
          table.markup());
}

Markup ratios_table(const std::vector<BenchRatio>& ratios) {
  TableMarkup table("Promised ratios, as measured in this run",
                    {"what", "#measured", "#promised", "verdict", "of"});
  for (const BenchRatio& ratio : ratios)
    table.row({{ratio.what, false, "wide"},
               number_cell(two_digits(ratio.measured)),
               number_cell(fmt::format("{:g}", ratio.target)),
               {met_mark(ratio.met())},
               {ratio.of_errors ? "errors" : "times"}});
  return table.markup();
}

}  // namespace

Markup speed_section(const Report& report, Plots& plots) {
  Markup drawn;
  TableMarkup others = speed_table("Quantities without a peer", true);
  std::size_t plotted = 0;
  for (const TimedGroup& group : timed_groups(report.speed.rows)) {
    if (group.drawn() < fewest_ways) {
      for (const BenchRow* row : group.rows) append_timed_row(others, *row, true);
      continue;
    }
    const Markup one = speed_group(group, plots);
    const std::string title = group.quantity + ", " + group.arguments;
    drawn += plotted++ == 0 ? element("h3", title) + one : details(title, one);
  }
  return section(
      "speed", "Speed against error",
      element(
          "p",
          "Medians of interleaved rounds in this run, one thread, with the quarter of the rounds that was quickest and the "
          "quarter that was slowest. A star: of the ways to the same values none was as quick and more right, or as right "
          "and quicker. Errors are the largest found against the reference; at N digits an ulp is 10^-N of the scale. Errors below 1e-17 are "
          "drawn there.") +
          ratios_table(report.speed.ratios) + drawn +
          details("All that is timed without others beside it", others.markup()));
}

}  // namespace nipref::verify
