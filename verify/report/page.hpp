#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/report/report.hpp>

namespace nipref::verify {

/// What a gnuplot script draws, as SVG; nothing where nothing draws. Called from several threads at once.
using Drawer = std::function<std::optional<std::string>(const std::string& script)>;

/// A report as one HTML file that needs nothing else, neither a network nor a script. Figures of the seeds are given,
/// all plots are drawn by `draw`; where it draws nothing the page says so in their places.
std::string report_page(const Report& report, const std::vector<Figure>& figures, const Drawer& draw);

}  // namespace nipref::verify
