#pragma once
#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/golden/check.hpp>
#include <nipref/verify/golden/golden.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/seeds/statements.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/json.hpp>
#include <nipref/verify/witness/witness.hpp>

namespace nipref::verify {

/// The kind of a difference between a number or a verdict of this report and the older one.
enum class Change { worse, slower, better, quicker, changed, appeared, gone };

/// "worse", "slower", "better", "quicker", "changed", "new", "gone"
std::string_view name(Change change);

struct ChangedItem {
  Change change;
  std::string what;         ///< "audit I1, largest error"
  std::string before, now;  ///< empty if the report does not have the item
};

/// The comparison of this report with an older one.
struct ReportComparison {
  std::string older;               ///< the commit from which the older report was built, and its date
  std::string note;                ///< what could not be compared, and why; may be empty
  std::vector<ChangedItem> items;  ///< worst first, in the order of Change

  [[nodiscard]] std::size_t count(Change change) const;
};

/// True if the text is the JSON of a report.
bool is_report(const std::string& json);

/// Compares two such texts. These are changes: a largest error that differs by a tenth, if both errors are of the same
/// number of points; a promised ratio of two times of one run that differs by a quarter (times themselves are not
/// compared); a count of verdicts; a promise that is now kept or broken; a row that is new or gone.
ReportComparison compare_reports(const std::string& older, const std::string& newer);

/// The comparison as the page and the text show it. The text shows at most this number of items.
Json comparison_json(const ReportComparison& comparison, std::size_t most_in_text = 10);

/// The golden values of one quantity, and the result of checking a sample of them.
struct GoldenSample {
  GoldenFile file;
  CheckedGolden checked;
};

/// The contents of a report, computed in one run.
struct Report : Audited {
  std::string command;  ///< the command line, quoted for a shell
  std::string seed;     ///< of the random scenes
  Witness witness;
  BenchReport speed;
  std::vector<Replay> tables;
  bool tables_fall_short = false;  ///< more cells are unexplained than are known to be
  std::vector<CheckedClaim> claims;
  std::vector<LimitRow> limits;
  std::vector<Settlement> errata;
  std::vector<GoldenSample> golden;
  std::vector<Figure> figures = {};                 ///< only if a page is written
  std::optional<ReportComparison> comparison = {};  ///< with an older report, if one is given
  std::vector<std::string> to_come = {};            ///< parts of the report that are not computed yet

  /// True if all promises are kept. Ratios of times, which depend on the machine, count only if `strict` is set.
  [[nodiscard]] bool kept(bool strict) const;
};

/// The result that uses the largest share of its promised error; null if there are no results.
const AuditResult* closest_to_its_promise(const std::vector<AuditResult>& results);

/// The answer of an audit, by itself and within a report.
Json audits_json(const Audited& audited, fast::Accuracy accuracy);

/// The answer of a report: the answers of its parts, counts, the errors of the seeds' methods, the definition and plot
/// of each quantity, golden values, and plots of times against errors.
Json report_json(const Report& report);
Json error_plot_json(const AuditResult& result);  ///< null if there are too few points
Json speed_plots_json(const std::vector<BenchRow>& rows);

/// Runs a gnuplot script and returns the SVG that it draws; empty if gnuplot is not installed. Must be thread-safe.
using Drawer = std::function<std::optional<std::string>(const std::string& script)>;

/// The answer of a report as one HTML file, which needs no network and no scripts, by the template report.html. `draw`
/// draws the plots; the page says so where a plot could not be drawn. `has_mathematics`: mathematics.html, which the
/// page then links, stands beside it.
std::string report_page(const std::string& answer, const Drawer& draw, bool has_mathematics = false);

/// The answer of a report as one screen of 80 columns, by the template report.txt: the build, a line or two for each
/// part, and the path of the page.
std::string report_text(const std::string& answer, const std::string& where_more_is);

/// The lines of such a text that begin with one of the heads, for example "errata", and their continuation lines.
std::string report_lines(const std::string& text, const std::vector<std::string>& heads);

}  // namespace nipref::verify
