#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include <nipref/verify/figures/render.hpp>

namespace nipref::verify {
namespace {

struct Style {
  std::string_view colour;
  std::string_view dashes;
  int open_symbol, filled_symbol;  ///< gnuplot's numbers
};

/// Colours are Okabe and Ito's, without their yellow, which is none on white, and with a grey.
constexpr std::array<Style, 8> styles{{{"#000000", "1", 4, 5},
                                       {"#0072B2", "(14,5)", 6, 7},
                                       {"#D55E00", "(5,4)", 8, 9},
                                       {"#009E73", "(14,4,2,4)", 10, 11},
                                       {"#CC79A7", "(2,3)", 12, 13},
                                       {"#E69F00", "(14,4,2,4,2,4)", 14, 15},
                                       {"#56B4E9", "(8,8)", 1, 3},
                                       {"#777777", "(4,2,2,2)", 2, 3}}};

/// A line for each of its parts.
std::string broken_at_semicolons(std::string text) {
  for (std::size_t at = 0; (at = text.find("; ", at)) != std::string::npos; ++at) text.replace(at, 2, "\n");
  return text;
}

std::string quoted_for_gnuplot(const std::string& text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter == '\n' ? std::string("\\n") : std::string(1, letter);
  }
  return quoted + "\"";
}

/// Each once, in the order of their first series.
std::vector<std::string> each_once(const std::vector<Series>& all, std::string Series::*what) {
  std::vector<std::string> names;
  for (const Series& series : all) {
    if (std::ranges::find(names, series.*what) == names.end()) names.push_back(series.*what);
  }
  return names;
}

/// The plots that make up a series, but for its data; the last one stands in the key. gnuplot's own error bars would put
/// a white disc below each point.
std::vector<std::string> drawn(Mark mark, const Style& style, std::size_t points) {
  const std::string colour = fmt::format("lc rgb \"{}\"", style.colour);
  const auto bars = [](double width, std::string_view of_colour) {
    return fmt::format("using 1:3:(0):($4-$3) with vectors nohead lw {} dt 1 lc rgb \"{}\"", width,
                       of_colour);
  };
  switch (mark) {
    case Mark::line:
      return {fmt::format("with lines lw 2 dt {} {}", style.dashes, colour)};
    case Mark::dots:
      return {fmt::format("with points pt 7 ps 0.2 {}", colour)};
    case Mark::marked_line:
      return {fmt::format("with linespoints lw 1 dt 1 pt {} ps 0.6 pi {} {}", style.open_symbol,
                          std::max<std::size_t>(1, points / 12), colour)};
    case Mark::points:
      return {fmt::format("with points pt {} ps 1 lw 1.3 {}", style.open_symbol, colour)};
    case Mark::bars:
      return {bars(1, style.colour),
              fmt::format("using 1:2 with points pt {} ps 0.55 {}", style.filled_symbol, colour)};
    case Mark::ranges:
      return {bars(6, "#999999")};
    case Mark::star:
      return {fmt::format("with points pt 3 ps 1.2 lw 1.5 {}", colour)};
  }
  return {};
}

std::string data_of(const Series& series, std::size_t number) {
  std::string text = fmt::format("$series{} << END\n", number);
  for (std::size_t i = 0; i < series.x.size(); ++i)
    text += series.low.empty()
                ? fmt::format("{} {}\n", series.x[i], series.y[i])
                : fmt::format("{} {} {} {}\n", series.x[i], series.y[i], series.low[i], series.high[i]);
  return text + "END\n";
}

/// What finds a panel's lines of equal value; their levels stand beside them.
std::string contour_commands(const Contours& contours) {
  std::string text = "$grid << END\n";
  for (std::size_t i = 0; i < contours.values.size(); ++i) {
    const std::size_t column = i % contours.x.size();
    if (i > 0 && column == 0) text += "\n";
    text +=
        fmt::format("{} {} {}\n", contours.x[column], contours.y[i / contours.x.size()], contours.values[i]);
  }
  return text +
         fmt::format(
             "END\nset contour base\nunset surface\nset cntrparam levels incremental -10,{},10\n"
             "set table $contours\nsplot $grid using 1:2:3 with lines\nunset table\nunset contour\nset surface\n",
             contours.step);
}

/// Negative ones are dashed, zero thick.
std::vector<std::string> drawn_contours() {
  const auto lines = [](std::string_view which, std::string_view how) {
    return fmt::format("$contours using 1:({} ? $2 : NaN) with lines {} notitle", which, how);
  };
  return {
      lines("$3 > 1e-9", "lw 1.2 dt 1 lc rgb \"#D55E00\""),
      lines("$3 < -1e-9", "lw 1.2 dt (8,5) lc rgb \"#0072B2\""),
      lines("abs($3) <= 1e-9", "lw 2.2 dt 1 lc rgb \"#000000\""),
      "$contours using 1:2:(sprintf(\"%g\", abs($3) < 1e-9 ? 0 : $3)) every 60::25 with labels font \",11\" notitle"};
}

/// A line of the key without data.
std::string key_line(const std::string& how, const std::string& name) {
  return fmt::format("keyentry {} title {}", how, quoted_for_gnuplot(name));
}

/// Where each series has a label of its own, all as they are drawn.
std::vector<std::string> key_of_series(const Panel& panel) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const std::string how = drawn(panel.series[i].mark, styles.at(i), 1).back();
    lines.push_back(key_line(how.substr(how.find("with")), panel.series[i].label));
  }
  return lines;
}

/// What tells labels apart, then in black what tells roles apart; what all have in common is not told.
std::vector<std::string> key_of_panel(const Panel& panel) {
  std::vector<std::string> lines;
  const auto labels = each_once(panel.series, &Series::label), roles = each_once(panel.series, &Series::role);
  if (labels.size() == panel.series.size() && roles.size() > 1) return key_of_series(panel);
  for (std::size_t i = 0; labels.size() > 1 && i < labels.size(); ++i)
    lines.push_back(key_line(fmt::format("with linespoints lw 2 dt {} pt {} lc rgb \"{}\"",
                                         styles.at(i).dashes, styles.at(i).open_symbol, styles.at(i).colour),
                             labels[i]));
  for (std::size_t i = 0; roles.size() > 1 && i < roles.size(); ++i) {
    const auto first = std::ranges::find(panel.series, roles[i], &Series::role);
    const std::string how = drawn(first->mark, styles[0], 1).back();
    lines.push_back(key_line(how.substr(how.find("with")), roles[i]));
  }
  return lines;
}

std::string axis_commands(char which, const FigureAxis& axis) {
  return fmt::format("set {0}label {1}\n{2} logscale {0}\nset format {0} \"%g\"\n", which,
                     quoted_for_gnuplot(axis.label), axis.logarithmic ? "set" : "unset");
}

std::string panel_commands(const Panel& panel) {
  std::string text;
  for (std::size_t i = 0; i < panel.series.size(); ++i) text += data_of(panel.series[i], i);
  text += axis_commands('x', panel.x) + axis_commands('y', panel.y);
  text += panel.contours ? fmt::format("set title {}\n", quoted_for_gnuplot(panel.contours->label))
                         : "unset title\n";
  text += panel.equal_scales ? "set size ratio -1\n" : "set size noratio\n";
  const auto labels = each_once(panel.series, &Series::label);
  std::vector<std::string> parts;
  if (panel.contours) {
    text += contour_commands(*panel.contours) +
            fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", panel.contours->x.front(),
                        panel.contours->x.back(), panel.contours->y.front(), panel.contours->y.back());
    parts = drawn_contours();
  }
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const Series& series = panel.series[i];
    if (series.x.empty()) continue;
    const auto label = static_cast<std::size_t>(std::ranges::find(labels, series.label) - labels.begin());
    for (const std::string& how : drawn(series.mark, styles.at(label), series.x.size()))
      parts.push_back(fmt::format("$series{} {} notitle", i, how));
  }
  std::ranges::move(key_of_panel(panel), std::back_inserter(parts));
  text += "plot ";
  for (std::size_t i = 0; i < parts.size(); ++i) text += (i == 0 ? "" : ", \\\n  ") + parts[i];
  return text + "\n";
}

}  // namespace

std::string gnuplot_script(const Figure& figure) {
  const std::size_t panels = figure.panels.size();
  const std::size_t columns = panels == 4 ? 2 : 1, rows = panels / columns;
  const std::string caption = fmt::format("{}: {}\n{}\nnipref figures {}", figure.id, figure.title,
                                          broken_at_semicolons(figure.parameters), figure.id);
  std::string text = fmt::format(
      "set encoding utf8\n"
      "set terminal svg noenhanced size {},{} font \"Helvetica,14\" background \"#ffffff\"\n"
      "set key outside right top Left reverse samplen 4 spacing 1.1\n"
      "set grid lc rgb \"#dddddd\" lw 0.5\n"
      "set multiplot layout {},{} title {} font \"Helvetica,15\"\n",
      columns * 950, 110 + rows * 460, rows, columns, quoted_for_gnuplot(caption));
  for (const Panel& panel : figure.panels) text += panel_commands(panel);
  return text + "unset multiplot\n";
}

std::string gnuplot_script(const Panel& panel) {
  const bool has_long_key = panel.series.size() > 4;
  return fmt::format(
             "set encoding utf8\n"
             "set terminal svg noenhanced size 480,{} font \"Helvetica,13\" background \"#ffffff\"\n"
             "set key below center {} Left reverse samplen 2 width -2\n"
             "set grid lc rgb \"#dddddd\" lw 0.5\n"
             "set offsets graph 0, graph 0, graph 0.08, graph 0\n{}",
             has_long_key ? 400 : 330, has_long_key ? "vertical maxrows 3" : "horizontal",
             panel.y.logarithmic ? "" : "set yrange [0:]\n") +
         panel_commands(panel);
}

}  // namespace nipref::verify
