#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/audit/internal/contacts.hpp>
#include <nipref/verify/audit/internal/scene_tally.hpp>
#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/golden/check.hpp>
#include <nipref/verify/golden/golden.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/seeds/statements.hpp>
#include <nipref/verify/support/json.hpp>
#include <nipref/verify/witness/witness.hpp>

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

/// Golden values of one quantity: what is kept, and what came of a sample of them.
struct GoldenSample {
  GoldenFile file;
  CheckedGolden checked;
};

/// All that a report tells, computed in one run.
struct Report {
  std::string command;  ///< that asked for it, as words of a shell
  std::string seed;     ///< of the random scenes
  std::vector<AuditResult> quantities;
  std::vector<ContactAudit> hard_cases;
  std::vector<SceneTally> scenes;
  Witness witness;
  BenchReport speed;
  std::vector<Replay> tables;
  bool tables_fall_short = false;  ///< cells are unexplained that are not known to be
  std::vector<CheckedClaim> claims;
  std::vector<LimitRow> limits;
  std::vector<SettledErratum> errata;
  std::vector<GoldenSample> golden;
  std::vector<Figure> figures = {};                 ///< where a page is asked for
  std::optional<ReportComparison> comparison = {};  ///< with an older report

  /// Whether nothing falls short, but for ratios of times, which depend on the machine: these if `strict` alone.
  [[nodiscard]] bool kept(bool strict) const;
};

/// The result that is closest to what it is allowed, or farthest beyond; none if there are no results.
const AuditResult* closest_to_its_promise(const std::vector<AuditResult>& results);

/// How far a column of some tables is from the truth at the worst row.
struct SeedError {
  std::string what;   ///< "contact length of the thesis's tables"
  std::string table;  ///< the worst one
  double relative;    ///< of the truth, with its sign
  std::string cause;  ///< what makes it, against what
};

/// How wrong the seeds are by their methods: contact length and rolling resistance of the thesis by its line loads, the
/// span ratio of Brock's first table of 2013 by its formula. Those whose tables are there.
std::vector<SeedError> seed_errors(const std::vector<Replay>& tables);

}  // namespace nipref::verify
