#pragma once
#include <string>

#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// A line for each point: panel, label, role, x, y, low, high, value. Where there are no bars, low and high are y; value
/// is what contours are of, which have neither.
std::string figure_csv(const Figure& figure);

Json panel_json(const Panel& panel);
Json figure_json(const Figure& figure);

/// Title, parameters, the command that draws it, and what is in it.
std::string figure_text(const Figure& figure);

/// What has gnuplot write the figure as SVG to its standard output. Labels differ in colour (Okabe and Ito's, which
/// colour-blind readers tell apart), in dashes and in symbols; roles in how they are drawn.
std::string gnuplot_script(const Figure& figure);

}  // namespace nipref::verify
