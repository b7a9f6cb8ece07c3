#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// What has become of a number or a verdict.
enum class Change { worse, slower, better, quicker, changed, appeared, gone };

/// "worse", "slower", "better", "quicker", "changed", "new", "gone"
std::string_view name(Change change);

struct ChangedItem {
  Change change;
  std::string what;         ///< "audit I1, largest error"
  std::string before, now;  ///< one of them is empty of what is new or gone
};

/// This report against an older one.
struct ReportComparison {
  std::string older;               ///< the commit that the older one was built from, and its date
  std::string note;                ///< what could not be compared, and why; may be empty
  std::vector<ChangedItem> items;  ///< worst first, in the order of Change

  [[nodiscard]] std::size_t count(Change change) const;
};

/// Whether a text is the report.json of a report.
bool is_report(const std::string& json);

/// Compares two texts that are. Largest errors that differ by a tenth, where as many points were looked at; promised ratios of
/// times, which are of one run each, by a quarter, never times; counts of verdicts; and whatever is kept, broken, new or
/// gone.
ReportComparison compare_reports(const std::string& older, const std::string& newer);

/// What the page shows.
Json comparison_json(const ReportComparison& comparison);

/// The counts, then a line for each item, of those many at most.
std::string comparison_text(const ReportComparison& comparison, std::size_t most_items);

}  // namespace nipref::verify
