#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/report/report.hpp>

namespace nipref::verify {
namespace {

constexpr std::size_t fewest_dots = 12;
constexpr double largest_linear_promise = 64;
constexpr std::size_t fewest_ways = 4;  ///< a plot has at least so many ways to the same values
constexpr double least_drawn_error = 1e-17;

/// On a logarithmic axis without the errors that are 0.
Series error_series(const std::string& label, Mark mark, const std::vector<ErrorDot>& dots, bool largest_only,
                    bool logarithmic) {
  Series series{label, label, mark, {}, {}};
  for (const ErrorDot& dot : dots) {
    if ((largest_only && !dot.largest) || (logarithmic && dot.ulps <= 0)) continue;
    series.x.push_back(dot.at);
    series.y.push_back(dot.ulps);
  }
  return series;
}

/// The name with the unit, if the argument has one.
std::string label_of(const Argument& argument, bool decades) {
  const std::string name = decades ? "|" + argument.name + "|" : argument.name;
  switch (argument.kind) {
    case ArgumentKind::nonzero_position:
    case ArgumentKind::position:
    case ArgumentKind::depth:
      return name + ", half-thicknesses";
    case ArgumentKind::degrees:
      return name + ", degrees";
    default:
      return name;
  }
}

/// The error of all points against one argument.
Panel error_panel(const AuditResult& result) {
  const Argument& argument = result.quantity->arguments[result.spread.along];
  const bool decades = spans_decades(argument.kind);
  const bool logarithmic = result.promise > largest_linear_promise || !result.kept();
  const auto& dots = result.spread.dots;
  Panel panel{{label_of(argument, decades), decades},
              {"error, ulp", logarithmic},
              {error_series("largest", Mark::line, dots, true, logarithmic),
               error_series("points", Mark::dots, dots, false, logarithmic),
               {"promise",
                "promise",
                Mark::line,
                {dots.front().at, dots.back().at},
                {result.promise, result.promise}}}};
  if (std::isfinite(result.worst_ulp) && (!logarithmic || result.worst_ulp > 0))
    panel.series.push_back({"worst",
                            "worst",
                            Mark::star,
                            {place_on_axis(argument.kind, result.worst[result.spread.along])},
                            {result.worst_ulp}});
  return panel;
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

/// Times of the ways to the same values against their errors.
Panel speed_panel(const std::vector<const BenchRow*>& ways) {
  Panel panel{{"largest error, relative", true}, {"time of a value, ns", true}, {}};
  Series best{"none better in this run", "none better in this run", Mark::star, {}, {}};
  for (const BenchRow* row : ways) {
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

}  // namespace

Json error_plot_json(const AuditResult& result) {
  return result.spread.dots.size() < fewest_dots ? Json() : panel_json(error_panel(result));
}

Json speed_plots_json(const std::vector<BenchRow>& rows) {
  std::vector<Json> plots;
  std::vector<const BenchRow*> seen;
  const auto same_values = [](const BenchRow& one, const BenchRow& other) {
    return one.quantity == other.quantity && one.arguments == other.arguments;
  };
  for (const BenchRow& first : rows) {
    if (std::ranges::any_of(seen, [&](const BenchRow* one) { return same_values(*one, first); })) continue;
    seen.push_back(&first);
    std::vector<const BenchRow*> ways;
    for (const BenchRow& row : rows) {
      if (same_values(row, first) && row.max_relative_error && std::isfinite(*row.max_relative_error))
        ways.push_back(&row);
    }
    if (ways.size() >= fewest_ways)
      plots.push_back({{"quantity", first.quantity},
                       {"range", first.arguments},
                       {"plot", panel_json(speed_panel(ways))}});
  }
  return plots;
}

}  // namespace nipref::verify
