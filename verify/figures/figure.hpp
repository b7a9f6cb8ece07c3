#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// An axis of a figure.
struct FigureAxis {
  std::string label;  ///< label with the unit
  bool logarithmic = false;
};

/// How the points of a series are drawn.
enum class Mark {
  line,         ///< a curve with the dashes of its label
  dots,         ///< a dot at each point
  marked_line,  ///< a thin curve with open symbols here and there
  points,       ///< open symbols, one at each point
  bars,         ///< filled symbols with bars from `low` to `high`
  ranges,       ///< the bars without symbols
  star          ///< a star at one point
};

/// Points of one kind. Within a figure, series with the same label have the same colour, dash and symbol, and series
/// with the same role have the same kind of mark.
struct Series {
  std::string label;  ///< the case: "B = 1 in"
  std::string role;   ///< the source: "continuous contact", "thesis's method", "printed"
  Mark mark;
  std::vector<double> x, y;
  std::vector<double> low = {}, high = {};  ///< ends of the bars; both empty without bars
};

/// Lines of equal value over a rectangle of x and y, at all multiples of `step`.
struct Contours {
  std::string label;
  std::vector<double> x, y;
  std::vector<double> values;  ///< at all x for the first y, then at all x for the next y, and so on
  double step;
};

/// One pair of axes.
struct Panel {
  FigureAxis x, y;
  std::vector<Series> series;
  bool equal_scales = false;  ///< both axes have the same scale
  std::optional<Contours> contours = {};
};

/// A figure that is not computed yet.
struct FigurePlan {
  std::string id;          ///< "thesis-17": the seed and the number of its figure or table; "coulomb-creep"
  std::string title;       ///< in our own words
  std::string parameters;  ///< parameters common to all curves
  std::function<std::vector<Panel>()> compute;
};

/// A figure with all its numbers.
struct Figure {
  std::string id, title, parameters;
  std::vector<Panel> panels;
};

/// All figures that can be drawn, from the rows of data/statements/figures.csv; their panels are in drawings.toml.
/// There are the thesis's figures with curves, in the order of their numbers, the curves on which the half-space
/// papers' tables lie, and figures of nips with Coulomb's friction, beyond the seeds. The seeds' own drawings are lost;
/// the axes follow the captions and the text.
[[nodiscard]] std::vector<FigurePlan> figures();

/// Computes a figure in less than a second, or in some seconds for rolling sheets and Coulomb's friction. If the seed
/// printed a table, the figure shows the table's cells with their rounding intervals, without doubtful cells, and the
/// values of the seed's own method.
[[nodiscard]] Figure compute(const FigurePlan& plan);

/// A CSV line for each point: panel, label, role, x, y, low, high, value. Without bars, low and high are y. Only
/// contours have a value; their low and high are empty.
std::string figure_csv(const Figure& figure);

Json panel_json(const Panel& panel);
Json figure_json(const Figure& figure);

/// A gnuplot script that writes an SVG to its standard output, for an answer of figure_json or panel_json. The drawing
/// of a panel has no caption and is readable at half the width of a sheet of paper and on a telephone. Labels differ in
/// colour (those of Okabe and Ito, for colour-blind readers), dash and symbol; roles differ in the kind of mark.
std::string gnuplot_script(const Json& drawing);

/// Runs such a script and returns its SVG; nothing without gnuplot. Throws std::runtime_error if gnuplot fails.
std::optional<std::string> drawn_by_gnuplot(const std::string& script);

}  // namespace nipref::verify
