#include <fmt/format.h>

#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/support/internal/number_text.hpp>

namespace nipref::verify {
namespace {

/// In the order of Mark.
constexpr const char* mark_names[] = {"line", "dots", "marked-line", "points", "bars", "ranges", "star"};

std::string panel_name(const Panel& panel) {
  return (panel.contours ? panel.contours->label + ", " : "") + panel.y.label + " against " + panel.x.label;
}

/// Null for an empty list.
Json numbers_json(const std::vector<double>& values) {
  return values.empty() ? Json() : json_list(values, [](double value) { return Json(value); });
}

Json series_json(const Series& series) {
  return {{"label", series.label},
          {"role", series.role},
          {"mark", mark_names[static_cast<std::size_t>(series.mark)]},
          {"x", numbers_json(series.x)},
          {"y", numbers_json(series.y)},
          {"low", numbers_json(series.low)},
          {"high", numbers_json(series.high)}};
}

Json axis_json(const FigureAxis& axis) { return {{"label", axis.label}, {"logarithmic", axis.logarithmic}}; }

Json contours_json(const Contours& contours) {
  return {{"label", contours.label},
          {"x", numbers_json(contours.x)},
          {"y", numbers_json(contours.y)},
          {"values", numbers_json(contours.values)},
          {"step", contours.step}};
}

std::string contours_csv(const std::string& panel, const Contours& contours) {
  std::string text;
  const std::string start = csv_field(panel) + "," + csv_field(contours.label) + ",contours";
  for (std::size_t i = 0; i < contours.values.size(); ++i)
    text += fmt::format("{},{},{},,,{}\n", start, contours.x[i % contours.x.size()],
                        contours.y[i / contours.x.size()], contours.values[i]);
  return text;
}

}  // namespace

std::string figure_csv(const Figure& figure) {
  std::string text = "panel,label,role,x,y,low,high,value\n";
  for (const Panel& panel : figure.panels) {
    for (const Series& series : panel.series) {
      const std::string start =
          csv_field(panel_name(panel)) + "," + csv_field(series.label) + "," + csv_field(series.role);
      for (std::size_t i = 0; i < series.x.size(); ++i)
        text += fmt::format("{},{},{},{},{},\n", start, series.x[i], series.y[i],
                            series.low.empty() ? series.y[i] : series.low[i],
                            series.high.empty() ? series.y[i] : series.high[i]);
    }
    if (panel.contours) text += contours_csv(panel_name(panel), *panel.contours);
  }
  return text;
}

Json panel_json(const Panel& panel) {
  return {{"x_axis", axis_json(panel.x)},
          {"y_axis", axis_json(panel.y)},
          {"equal_scales", panel.equal_scales},
          {"series", json_list(panel.series, series_json)},
          {"contours", panel.contours ? contours_json(*panel.contours) : Json()}};
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
    text += fmt::format("  {}: {} series{}\n", panel_name(panel), panel.series.size(),
                        panel.contours ? ", contours" : "");
  return text;
}

}  // namespace nipref::verify
