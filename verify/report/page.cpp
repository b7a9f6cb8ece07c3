#include <cctype>
#include <nlohmann/json.hpp>

#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/report/report.hpp>
#include <nipref/verify/support/internal/parallel.hpp>
#include <nipref/verify/support/internal/template.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

using Keys = std::vector<const char*>;

TemplateData* row_like(TemplateData& rows, const TemplateData& row, const Keys& keys) {
  const auto found = std::ranges::find_if(rows, [&](const TemplateData& one) {
    return std::ranges::all_of(keys, [&](const char* key) { return one.at(key) == row.at(key); });
  });
  return found == rows.end() ? nullptr : &*found;
}

/// Adds to each row the members of the row of `more` that has the same keys.
void join(TemplateData& rows, TemplateData& more, const Keys& keys) {
  for (TemplateData& row : rows)
    if (const TemplateData* const other = row_like(more, row, keys)) row.update(*other);
}

/// Groups rows with the same keys: a group has these keys, and its rows as `rows`.
TemplateData grouped(const TemplateData& rows, const Keys& keys) {
  TemplateData groups = TemplateData::array();
  for (const TemplateData& row : rows) {
    TemplateData* group = row_like(groups, row, keys);
    if (group == nullptr) {
      TemplateData empty{{"rows", TemplateData::array()}};
      for (const char* key : keys) empty[key] = row[key];
      group = &groups.emplace_back(std::move(empty));
    }
    (*group)["rows"].push_back(row);
  }
  return groups;
}

/// Encodes the text for a URL (RFC 3986). Runs of white space, which gnuplot writes often, become single spaces.
std::string percent_encoded(const std::string& svg) {
  constexpr std::string_view plain = "!'()*+,-./:;=?@_|$[]";
  std::string url;
  for (const char letter : svg) {
    const auto byte = static_cast<unsigned char>(letter);
    if (std::isspace(byte) != 0) {
      if (!url.empty() && url.back() != ' ') url += ' ';
    } else if ((std::isalnum(byte) != 0 && byte < 128) || plain.find(letter) != std::string_view::npos) {
      url += letter;
    } else {
      url += fmt::format("%{:02X}", byte);
    }
  }
  return url;
}

/// Draws the plots of the rows in several threads and puts the pictures in their place.
void draw_all(TemplateData& rows, const Drawer& draw) {
  std::vector<TemplateData*> plotted;
  for (TemplateData& row : rows)
    if (row.contains("plot") && !row["plot"].is_null()) plotted.push_back(&row);
  parallel_for(plotted.size(), [&](std::size_t i) {
    TemplateData& row = *plotted[i];
    const auto svg = draw(gnuplot_script(Json::parse(row["plot"].dump())));
    row["picture"] = svg ? TemplateData(percent_encoded(*svg)) : TemplateData();
    row.erase("plot");
  });
}

/// Rearranges the answer for the page's template.
TemplateData arranged(const std::string& answer, const Drawer& draw) {
  TemplateData page = TemplateData::parse(answer);
  page["coming"] = !page["to_come"].empty();
  TemplateData& rows = page["audit"]["rows"];
  join(rows, page["quantities"], {"quantity"});
  join(page["golden"], page["golden_values"], {"quantity"});
  join(page["tables"]["tables"], page["summary"]["tables"], {"id"});
  // An insertion moves the members of the page, so no reference to a member is kept beyond an insertion.
  page["ways"] = grouped(page["bench"]["rows"], {"quantity", "range"});
  if (page.contains("times")) join(page["ways"], page["times"]["plots"], {"quantity", "range"});
  for (TemplateData& figure : page["figures"])
    figure = {{"id", figure["id"]},
              {"title", figure["title"]},
              {"parameters", figure["parameters"]},
              {"plot", figure}};
  for (TemplateData& table : page["tables"]["tables"]) {
    join(table["cells"], table["columns"], {"column"});
    for (TemplateData& cell : table["cells"]) cell["judged"] = cell["verdict"] != "input";
    table["rows"] = grouped(table["cells"], {"row"});
    table["columns"] = table["rows"].empty() ? TemplateData() : table["rows"].front()["rows"];
  }
  for (const char* list : {"ways", "figures"}) draw_all(page[list], draw);
  draw_all(rows, draw);
  TemplateData drawn = TemplateData::array();
  std::ranges::copy_if(rows, std::back_inserter(drawn),
                       [](const TemplateData& row) { return row.contains("picture"); });
  page["subjects"] = grouped(drawn, {"subject"});
  for (TemplateData& subject : page["subjects"]) subject["count"] = subject["rows"].size();
  for (TemplateData& row : rows) row.erase("picture");
  for (TemplateData& one : page["ways"]) one["drawn"] = one.contains("picture");
  for (const char* list : {"subjects", "ways"})
    if (!page[list].empty()) page[list].front()["first"] = true;
  return page;
}

constexpr std::size_t fewest_dots = 12;
constexpr double largest_linear_promise = 64;
constexpr int fewest_ways = 4;  ///< least number of ways to the same values in a plot
constexpr double least_drawn_error = 1e-17, most_drawn_error = 10;

/// A series of errors. On a logarithmic axis errors of 0 are left out.
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
  using enum ArgumentKind;
  if (argument.kind == nonzero_position || argument.kind == position || argument.kind == depth)
    return name + ", half-thicknesses";
  return argument.kind == degrees ? name + ", degrees" : name;
}

/// Plots the error of all points against one argument.
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

/// The name of a method without its accuracy: "fast batch" for "fast batch rtol=1e-06".
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
  series.x.push_back(std::clamp(*row.max_relative_error, least_drawn_error, most_drawn_error));
  series.y.push_back(row.nanoseconds);
  if (series.mark != Mark::bars) return;
  series.low.push_back(row.quartile_1 > 0 ? row.quartile_1 : row.nanoseconds);
  series.high.push_back(row.quartile_3 > 0 ? row.quartile_3 : row.nanoseconds);
}

bool has_error(const BenchRow& row) {
  return row.max_relative_error && std::isfinite(*row.max_relative_error);
}

/// Plots the times of all ways to the same values against their errors.
Panel speed_panel(std::span<const BenchRow> ways) {
  Panel panel{{"largest error, relative", true}, {"time of a value, ns", true}, {}};
  Series best{"none better in this run", "none better in this run", Mark::star, {}, {}};
  for (const BenchRow& row : ways) {
    if (!has_error(row)) continue;
    const std::string family = family_of(row.method);
    auto series = std::ranges::find(panel.series, family, &Series::label);
    if (series == panel.series.end()) {
      panel.series.push_back({family, family, Mark::bars, {}, {}});
      series = panel.series.end() - 1;
    }
    append_way(*series, row);
    if (row.pareto_optimal) append_way(best, row);
  }
  if (!best.x.empty()) panel.series.push_back(best);
  return panel;
}

}  // namespace

std::string report_page(const std::string& answer, const Drawer& draw, bool has_mathematics) {
  TemplateData page = arranged(answer, draw);
  page["mathematics"] = has_mathematics;
  return filled(template_text("report.html"), page, escaped_for_html);
}

std::string report_text(const std::string& answer, const std::string& where_more_is) {
  TemplateData data = TemplateData::parse(answer);
  data["page"] = where_more_is;
  return folded(filled_text(template_text("report.txt"), data));
}

std::string report_lines(const std::string& text, const std::vector<std::string>& heads) {
  std::istringstream lines(text);
  std::string chosen;
  bool is_chosen = false;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(' '))
      is_chosen = std::ranges::any_of(heads, [&](const auto& head) { return line.starts_with(head + " "); });
    if (is_chosen) chosen += line + "\n";
  }
  return chosen;
}

Json error_plot_json(const AuditResult& result) {
  return result.spread.dots.size() < fewest_dots ? Json() : panel_json(error_panel(result));
}

Json speed_plots_json(const std::vector<BenchRow>& rows) {
  std::vector<Json> plots;
  for (const auto& ways : ways_to_same_values(rows)) {
    if (std::ranges::count_if(ways, has_error) < fewest_ways) continue;
    plots.push_back({{"quantity", ways.front().quantity},
                     {"range", ways.front().arguments},
                     {"plot", panel_json(speed_panel(ways))}});
  }
  return plots;
}

}  // namespace nipref::verify
