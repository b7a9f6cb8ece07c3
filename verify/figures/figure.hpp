#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// An axis of a figure.
struct FigureAxis {
  std::string label;  ///< with its unit
  bool logarithmic = false;
};

/// How the points of a series are drawn.
enum class Mark {
  line,         ///< a curve, in the dashes of its label
  dots,         ///< a dot at each point
  marked_line,  ///< a thin curve with open symbols here and there
  points,       ///< open symbols
  bars,         ///< filled symbols with bars from `low` to `high`
  ranges,       ///< the bars without symbols
  star          ///< marks one point
};

/// Points of one kind. In a figure, series of the same label have the same colour, dash and symbol, and series of the same
/// role are drawn in the same way.
struct Series {
  std::string label;  ///< the case: "B = 1 in"
  std::string role;   ///< the source: "continuous contact", "thesis's method", "printed"
  Mark mark;
  std::vector<double> x, y;
  std::vector<double> low = {}, high = {};  ///< ends of the bars; both empty where there are none
};

/// Lines of equal value over the rectangle of x and y, at all multiples of `step`.
struct Contours {
  std::string label;
  std::vector<double> x, y;
  std::vector<double> values;  ///< at all x for the first y, then for the next
  double step;
};

/// One pair of axes.
struct Panel {
  FigureAxis x, y;
  std::vector<Series> series;
  bool equal_scales = false;  ///< both axes have the same scale
  std::optional<Contours> contours = {};
};

/// A figure, not computed yet.
struct FigurePlan {
  std::string id;          ///< "thesis-17": the seed and the number of its figure or table; "coulomb-creep"
  std::string title;       ///< in our own words
  std::string parameters;  ///< common to its curves
  std::function<std::vector<Panel>()> compute;
};

/// A figure with all its numbers.
struct Figure {
  std::string id, title, parameters;
  std::vector<Panel> panels;
};

/// All figures that can be drawn, the rows of data/statements/figures.csv, whose panels are in drawings.toml: those of the
/// thesis that have curves, in the order of their numbers, the curves on which the tables of the papers on half-spaces lie, and
/// those of nips with Coulomb's friction, beyond the seeds. The seeds' own drawings are lost: the axes follow their captions
/// and text.
[[nodiscard]] std::vector<FigurePlan> figures();

/// Computes a figure, which takes less than a second, or some seconds for rolling sheets and Coulomb's friction. Where the
/// seed printed a table, the figure has its cells with their rounding intervals, without doubtful ones, and the values by the
/// seed's own method.
[[nodiscard]] Figure compute(const FigurePlan& plan);

/// A line for each point: panel, label, role, x, y, low, high, value. Without bars, low and high are y; only contours have a
/// value, and they have no low and high.
std::string figure_csv(const Figure& figure);

Json panel_json(const Panel& panel);
Json figure_json(const Figure& figure);

/// A script with which gnuplot writes an SVG to its standard output, of what figure_json answers; of what panel_json answers a
/// drawing without a caption, small enough for a page: readable at half the width of a sheet of paper and on a telephone.
/// Labels differ in colour (Okabe and Ito's, which colour-blind readers tell apart), in dashes and in symbols; roles in how
/// they are drawn.
std::string gnuplot_script(const Json& drawing);

/// The drawing by such a script, as SVG; nothing if gnuplot is not installed. Throws std::runtime_error if it fails.
std::optional<std::string> drawn_by_gnuplot(const std::string& script);

}  // namespace nipref::verify
