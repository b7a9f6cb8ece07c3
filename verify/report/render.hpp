#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nipref/verify/report/report.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// What the page and the text of a report show beyond the answers of the verbs, each number of it made here alone: counts,
/// each quantity's definition and plot, golden values, and plots of times against errors.
Json summary_json(const Report& report);
Json quantities_json(const std::vector<AuditResult>& results);
Json golden_values_json(const std::vector<GoldenSample>& samples);
Json error_plot_json(const AuditResult& result);  ///< null where there are too few points
Json speed_plots_json(const std::vector<BenchRow>& rows);

/// What a gnuplot script draws, as SVG; nothing where nothing draws. Called from several threads at once.
using Drawer = std::function<std::optional<std::string>(const std::string& script)>;

/// The answer of a report as one HTML file that needs nothing else, neither a network nor a script: the template
/// report.html. All plots are drawn by `draw`; where it draws nothing the page says so in their places.
std::string report_page(const std::string& answer, const Drawer& draw);

/// The answer as one screen of 80 columns, the template report.txt: what was built, a line or two for each part, and where
/// more is.
std::string report_text(const std::string& answer, const std::string& where_more_is);

}  // namespace nipref::verify
