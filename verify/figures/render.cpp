#include <fmt/format.h>

#include <nipref/verify/figures/render.hpp>
#include <nipref/verify/support/internal/csv_field.hpp>

namespace nipref::verify {
namespace {

std::string_view name(Mark mark) {
  switch (mark) {
    case Mark::line:
      return "line";
    case Mark::marked_line:
      return "marked-line";
    case Mark::points:
      return "points";
    case Mark::bars:
      return "bars";
    case Mark::ranges:
      return "ranges";
    case Mark::star:
      return "star";
  }
  return "";
}

std::string panel_name(const Panel& panel) { return panel.y.label + " against " + panel.x.label; }

Json series_json(const Series& series) {
  const auto numbers = [](const std::vector<double>& values) {
    return values.empty() ? Json() : json_list(values, [](double value) { return Json(value); });
  };
  return {{"label", series.label},       {"role", series.role},    {"mark", name(series.mark)},
          {"x", numbers(series.x)},      {"y", numbers(series.y)}, {"low", numbers(series.low)},
          {"high", numbers(series.high)}};
}

Json axis_json(const FigureAxis& axis) { return {{"label", axis.label}, {"logarithmic", axis.logarithmic}}; }

Json panel_json(const Panel& panel) {
  return {{"x_axis", axis_json(panel.x)},
          {"y_axis", axis_json(panel.y)},
          {"series", json_list(panel.series, series_json)}};
}

}  // namespace

std::string figure_csv(const Figure& figure) {
  std::string text = "panel,label,role,x,y,low,high\n";
  for (const Panel& panel : figure.panels) {
    for (const Series& series : panel.series) {
      const std::string start =
          csv_field(panel_name(panel)) + "," + csv_field(series.label) + "," + csv_field(series.role);
      for (std::size_t i = 0; i < series.x.size(); ++i)
        text += fmt::format("{},{},{},{},{}\n", start, series.x[i], series.y[i],
                            series.low.empty() ? series.y[i] : series.low[i],
                            series.high.empty() ? series.y[i] : series.high[i]);
    }
  }
  return text;
}

Json figure_json(const Figure& figure) {
  return {{"id", figure.id},
          {"title", figure.title},
          {"parameters", figure.parameters},
          {"panels", json_list(figure.panels, panel_json)}};
}

std::string figure_text(const Figure& figure) {
  std::string text = fmt::format("{}: {}\n  {}\n", figure.id, figure.title, figure.parameters);
  for (const Panel& panel : figure.panels)
    text += fmt::format("  {}: {} series\n", panel_name(panel), panel.series.size());
  return text;
}

}  // namespace nipref::verify
