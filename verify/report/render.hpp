#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nipref/verify/report/report.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

// The parts of a report's answer that are not answers of other verbs: counts, the definition and plot of each quantity,
// golden values, and plots of times against errors.
Json summary_json(const Report& report);
Json quantities_json(const std::vector<AuditResult>& results);
Json golden_values_json(const std::vector<GoldenSample>& samples);
Json error_plot_json(const AuditResult& result);  ///< null where there are too few points
Json speed_plots_json(const std::vector<BenchRow>& rows);

/// Runs a gnuplot script and returns the SVG that it draws; empty if gnuplot is not installed. Several threads call it.
using Drawer = std::function<std::optional<std::string>(const std::string& script)>;

/// The answer of a report as one HTML file, by the template report.html: it needs neither a network nor scripts. `draw` draws
/// the plots; in place of a plot that it cannot draw, the page says so.
std::string report_page(const std::string& answer, const Drawer& draw);

/// The answer as one screen of 80 columns, by the template report.txt: the build, a line or two for each part, and the path
/// of the page.
std::string report_text(const std::string& answer, const std::string& where_more_is);

}  // namespace nipref::verify
