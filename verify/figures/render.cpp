#include <nlohmann/json.hpp>
#include <stdexcept>

#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/figures/internal/drawings.hpp>
#include <nipref/verify/support/internal/number_text.hpp>
#include <nipref/verify/support/internal/process.hpp>
#include <nipref/verify/support/internal/template.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

/// Names of marks, in the order of Mark.
constexpr const char* mark_names[] = {"line", "dots", "marked-line", "points", "bars", "ranges", "star"};

std::string panel_name(const Panel& panel) {
  return (panel.contours ? panel.contours->label + ", " : "") + panel.y.label + " against " + panel.x.label;
}

/// The list of the values; null if there are none.
Json numbers_json(const std::vector<double>& values) { return values.empty() ? Json() : json_list(values); }

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

constexpr const char* columns_of_series[] = {"x", "y", "low", "high"};

/// Escapes a text for the double quotes of gnuplot.
std::string escaped_for_gnuplot(const std::string& text) {
  std::string quoted;
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter == '\n' ? std::string("\\n") : std::string(1, letter);
  }
  return quoted;
}

/// The labels or the roles without repetitions, in the order of the series.
std::vector<std::string> each_once(const TemplateData& all_series, const char* what) {
  return verify::each_once(
      mapped(all_series, [&](const auto& series) { return series[what].template get<std::string>(); }));
}

/// A part of the plot command: `data` drawn with a mark, in the style of this label.
TemplateData plot_of(const std::string& data, const std::string& mark, std::size_t label,
                     std::size_t points = 1) {
  return {
      {mark, true}, {"data", data}, {"style", label + 1}, {"every", std::max<std::size_t>(1, points / 12)}};
}

TemplateData key_entry(const std::string& legend, const std::string& mark, std::size_t label) {
  TemplateData entry = plot_of("keyentry", mark, label);
  entry["legend"] = legend;
  return entry;
}

/// Adds the key: an entry for each label, then a black entry for each role. A label or a role that all series share
/// gets no entry. If each series has its own label, its entry shows the series as drawn and roles have no entry.
void add_key(TemplateData& plots, const TemplateData& all_series) {
  const auto labels = each_once(all_series, "label"), roles = each_once(all_series, "role");
  const bool as_drawn = labels.size() == all_series.size() && roles.size() > 1;
  for (std::size_t i = 0; labels.size() > 1 && i < labels.size(); ++i)
    plots.push_back(
        key_entry(labels[i], as_drawn ? all_series[i]["mark"].get<std::string>() : "label_key", i));
  if (as_drawn || roles.size() < 2) return;
  for (const std::string& role : roles) {
    const auto first =
        std::ranges::find_if(all_series, [&](const TemplateData& series) { return series["role"] == role; });
    plots.push_back(key_entry(role, (*first)["mark"], 0));
  }
}

/// The data lines of a series, one for each point.
std::string rows_of(const TemplateData& series) {
  std::string text;
  for (std::size_t i = 0; i < series["x"].size(); ++i) {
    for (const char* column : columns_of_series)
      if (!series[column].is_null()) text += fmt::format("{} ", series[column][i].get<double>());
    text += "\n";
  }
  return text;
}

/// Adds the points in gnuplot's grid format: for each y a block with all x, and an empty line between blocks. Also adds
/// a scale of colours, one colour between neighbouring contours, which is symmetric about 0.
void add_grid(TemplateData& contours) {
  const TemplateData &x = contours["x"], &y = contours["y"];
  std::string text;
  for (std::size_t i = 0; i < contours["values"].size(); ++i)
    text += fmt::format("{}{} {} {}\n", i > 0 && i % x.size() == 0 ? "\n" : "", x[i % x.size()].get<double>(),
                        y[i / x.size()].get<double>(), contours["values"][i].get<double>());
  const double step = contours["step"];
  double steps = 1;  // the number of steps from 0 to the end of the scale
  for (const TemplateData& value : contours["values"])
    steps = std::max(steps, std::ceil(std::fabs(value.get<double>()) / step - 1e-9));
  contours.update({{"points", text},
                   {"largest", steps * step},
                   {"colours", 2 * steps},
                   {"tics", step * std::ceil(steps / 5)},
                   {"x_first", x.front()},
                   {"x_last", x.back()},
                   {"y_first", y.front()},
                   {"y_last", y.back()}});
}

void prepare(TemplateData& panel) {
  TemplateData plots = TemplateData::array();
  if (!panel["contours"].is_null()) {
    add_grid(panel["contours"]);
    plots.push_back({{"contours_drawn", true}});
  }
  const auto labels = each_once(panel["series"], "label");
  for (std::size_t i = 0; i < panel["series"].size(); ++i) {
    TemplateData& series = panel["series"][i];
    series["number"] = i;
    series["points"] = rows_of(series);
    const auto label = static_cast<std::size_t>(
        std::ranges::find(labels, series["label"].get<std::string>()) - labels.begin());
    if (!series["x"].empty())
      plots.push_back(plot_of(fmt::format("$series{}", i), series["mark"], label, series["x"].size()));
  }
  add_key(plots, panel["series"]);
  for (std::size_t i = 0; i + 1 < plots.size(); ++i) plots[i]["more"] = true;
  panel["plots"] = plots;
  for (TemplateData& series : panel["series"])
    for (const char* column : columns_of_series) series.erase(column);
}

}  // namespace

std::optional<Mark> mark_named(const std::string& name) {
  const auto found = std::ranges::find(mark_names, name);
  return found == std::end(mark_names) ? std::nullopt : std::optional(static_cast<Mark>(found - mark_names));
}

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
          {"contours", panel.contours ? contours_json(*panel.contours) : Json()},
          {"_name", panel_name(panel)},
          {"_count", panel.series.size()}};
}

Json figure_json(const Figure& figure) {
  return {{"id", figure.id},
          {"title", figure.title},
          {"parameters", figure.parameters},
          {"panels", json_list(figure.panels, panel_json)}};
}

std::string gnuplot_script(const Json& drawing) {
  TemplateData figure = TemplateData::parse(drawing.line());
  if (!figure.contains("panels")) figure = {{"panels", TemplateData::array({figure})}};
  TemplateData& panels = figure["panels"];
  for (TemplateData& panel : panels) prepare(panel);
  // A key beside a panel leaves no room for a second column of panels. Contours have no key.
  const std::size_t columns = panels[0]["contours"].is_null() ? 1 : 2, rows = panels.size() / columns;
  figure.update(
      {{"notes", parts_of(figure.value("parameters", ""), "; ")},
       {"long_key", panels[0]["series"].size() > 4},
       {"columns", columns},
       {"rows", rows},
       {"width", columns == 1 ? 950 : columns * 620},  // a page shows this width without scaling it down
       {"height", 110 + rows * (columns == 1 ? 460 : 400)}});
  return filled(template_text("figure.gnuplot"), figure, escaped_for_gnuplot);
}

std::optional<std::string> drawn_by_gnuplot(const std::string& script) {
  // -d ignores the user's settings. With this file name a script ends at its first error.
  const ProgramOutput drawn = output_of({"gnuplot", "-d", "/dev/stdin"}, script);
  if (drawn.status == status_not_found) return std::nullopt;
  if (drawn.status != 0) throw std::runtime_error("gnuplot does not draw: " + script.substr(0, 1000));
  return drawn.text;
}

}  // namespace nipref::verify
