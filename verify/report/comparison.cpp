#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include <nipref/verify/report/comparison.hpp>

namespace nipref::verify {
namespace {

using nlohmann::json;

constexpr double errors_differ = 1.1;
constexpr double times_differ = 1.25;

constexpr std::array<std::pair<Change, std::string_view>, 7> change_names{{{Change::worse, "worse"},
                                                                           {Change::slower, "slower"},
                                                                           {Change::better, "better"},
                                                                           {Change::quicker, "quicker"},
                                                                           {Change::changed, "changed"},
                                                                           {Change::appeared, "new"},
                                                                           {Change::gone, "gone"}}};

/// A list below a report; an older program may not have it.
const json& list_at(const json& report, const std::string& path) {
  static const json none = json::array();
  const json::json_pointer pointer(path);
  return report.contains(pointer) && report.at(pointer).is_array() ? report.at(pointer) : none;
}

/// A number that is finite.
std::optional<double> number_at(const json& row, const std::string& key) {
  if (!row.contains(key) || !row[key].is_number()) return std::nullopt;
  return row[key].get<double>();
}

std::string text_at(const json& row, const std::string& key) {
  if (!row.contains(key)) return "";
  return row[key].is_string() ? row[key].get<std::string>() : row[key].dump();
}

/// Puts together a comparison.
class Comparer {
 public:
  Comparer(const json& older, const json& newer) : older_(older), newer_(newer) {}

  using Rows = std::function<void(const std::string& what, const json& before, const json& now)>;

  /// Pairs the rows of a list by what identifies them; tells which are new or gone.
  void pair(const std::string& path, const std::string& part, const std::vector<std::string>& keys,
            const Rows& compare) {
    const auto before = by_name(list_at(older_, path), keys), now = by_name(list_at(newer_, path), keys);
    if (!older_.contains(json::json_pointer(path)) && !now.empty()) {
      add(Change::appeared, fmt::format("{}: all {}, which the older report does not have", part, now.size()),
          "", "");
      return;
    }
    for (const auto& [id, row] : now) {
      const std::string what = part + " " + id;
      const auto old = before.find(id);
      if (old == before.end()) {
        add(Change::appeared, what, "", "");
      } else {
        compare(what, *old->second, *row);
      }
    }
    for (const auto& [id, row] : before) {
      if (!now.contains(id)) add(Change::gone, part + " " + id, "", "");
    }
  }

  void add(Change change, std::string what, std::string before, std::string now) {
    items_.push_back({change, std::move(what), std::move(before), std::move(now)});
  }

  /// A truth value, true being good; true if it differs.
  bool verdict(const std::string& what, const json& before, const json& now, const std::string& key) {
    const std::string was = text_at(before, key), is = text_at(now, key);
    if (was == is) return false;
    add(is == "true" ? Change::better : Change::worse, what + ", " + key, was, is);
    return true;
  }

  /// A positive number, smaller being better.
  void size(const std::string& what, const json& before, const json& now, const std::string& key,
            double differs) {
    const auto was = number_at(before, key), is = number_at(now, key);
    if (!was || !is || std::max(*was, *is) <= differs * std::min(*was, *is)) return;
    add(*is < *was ? Change::better : Change::worse, what, fmt::format("{:.4g}", *was),
        fmt::format("{:.4g}", *is));
  }

  std::vector<ChangedItem> items() {
    std::ranges::stable_sort(items_, {}, &ChangedItem::change);
    return std::move(items_);
  }

 private:
  static std::map<std::string, const json*> by_name(const json& rows, const std::vector<std::string>& keys) {
    std::map<std::string, const json*> named;
    for (const json& row : rows) {
      std::string id;
      for (const std::string& key : keys) id += (id.empty() ? "" : ", ") + text_at(row, key);
      named.emplace(id, &row);
    }
    return named;
  }

  const json &older_, &newer_;
  std::vector<ChangedItem> items_;
};

/// The number of quantities whose largest errors are of other points.
std::size_t compare_audits(Comparer& comparer) {
  std::size_t other_points = 0;
  comparer.pair("/audit/rows", "audit", {"quantity"},
                [&](const std::string& what, const json& before, const json& now) {
                  const bool same_points = text_at(before, "points") == text_at(now, "points");
                  other_points += !same_points;
                  if (!comparer.verdict(what, before, now, "kept") && same_points)
                    comparer.size(what + ", largest error, ulp", before, now, "max_error_ulp", errors_differ);
                });
  return other_points;
}

void compare_contacts(Comparer& comparer) {
  comparer.pair("/audit/scenes", "random contacts", {"kind"},
                [&](const std::string& what, const json& before, const json& now) {
                  comparer.verdict(what, before, now, "kept");
                  if (text_at(before, "scenes") != text_at(now, "scenes")) return;
                  comparer.size(what + ", statement over error, median", before, now, "median_overestimate",
                                errors_differ);
                });
  comparer.pair("/audit/contacts", "hard case", {"system", "length_over_thickness", "poisson", "unknowns"},
                [&](const std::string& what, const json& before, const json& now) {
                  comparer.verdict(what, before, now, "kept");
                });
}

void compare_speed(Comparer& comparer) {
  const auto compare = [&](const std::string& what, const json& before, const json& now) {
    const auto was = number_at(before, "ratio"), is = number_at(now, "ratio");
    if (!was || !is || std::max(*was, *is) <= times_differ * std::min(*was, *is)) return;
    comparer.add(*is < *was ? Change::slower : Change::quicker, what, fmt::format("{:.3g}", *was),
                 fmt::format("{:.3g}", *is));
  };
  comparer.pair("/bench/times/ratios", "speed,", {"what"}, compare);
  comparer.pair("/bench/error_ratios", "error,", {"what"},
                [&](const std::string& what, const json& before, const json& now) {
                  comparer.verdict(what, before, now, "met");
                });
}

/// How many cells of a table have each verdict.
std::map<std::string, long> verdict_counts(const json& table) {
  std::map<std::string, long> counts;
  for (const json& cell : list_at(table, "/cells")) ++counts[text_at(cell, "verdict")];
  return counts;
}

/// Matches are good, what is unexplained is not; the others are neither.
Change change_of_count(const std::string& verdict, long difference) {
  if (verdict == "match") return difference > 0 ? Change::better : Change::worse;
  if (verdict == "unexplained") return difference < 0 ? Change::better : Change::worse;
  return Change::changed;
}

void compare_tables(Comparer& comparer) {
  comparer.pair(
      "/tables/tables", "table", {"id"}, [&](const std::string& what, const json& before, const json& now) {
        std::map<std::string, long> was = verdict_counts(before), is = verdict_counts(now);
        for (const std::string verdict : {"match", "misprint", "seed-error", "unexplained"}) {
          if (was[verdict] != is[verdict])
            comparer.add(change_of_count(verdict, is[verdict] - was[verdict]), what + ", cells: " + verdict,
                         std::to_string(was[verdict]), std::to_string(is[verdict]));
        }
      });
}

void compare_statements(Comparer& comparer) {
  comparer.pair("/claims", "claim", {"id"},
                [&](const std::string& what, const json& before, const json& now) {
                  const std::string was = text_at(before, "verdict"), is = text_at(now, "verdict");
                  if (was != is) comparer.add(Change::changed, what, was, is);
                });
  const auto same_verdict = [&](const char* key) {
    return [&comparer, key](const std::string& what, const json& before, const json& now) {
      comparer.verdict(what, before, now, key);
    };
  };
  comparer.pair("/limits", "limit", {"name"}, same_verdict("approached"));
  comparer.pair("/errata", "erratum", {"id"}, same_verdict("settled"));
  comparer.pair("/golden", "golden", {"quantity"}, same_verdict("kept"));
}

std::string version_of(const json& report) {
  const json& version = report.at("nipref");
  return text_at(version, "commit").substr(0, 10) + ", " + text_at(version, "commit_date");
}

}  // namespace

std::string_view name(Change change) {
  return std::ranges::find(change_names, change, &std::pair<Change, std::string_view>::first)->second;
}

std::size_t ReportComparison::count(Change change) const {
  return static_cast<std::size_t>(std::ranges::count(items, change, &ChangedItem::change));
}

bool is_report(const std::string& text) {
  const json report = json::parse(text, nullptr, false);
  return report.is_object() && report.contains("nipref") && report["nipref"].is_object() &&
         text_at(report, "verb") == "report";
}

ReportComparison compare_reports(const std::string& older, const std::string& newer) {
  const json before = json::parse(older), now = json::parse(newer);
  Comparer comparer(before, now);
  ReportComparison comparison{version_of(before), "", {}};
  if (const std::size_t other = compare_audits(comparer); other > 0)
    comparison.note = fmt::format(
        "of {} quantities other points were looked at: their largest errors are not compared", other);
  compare_contacts(comparer);
  compare_speed(comparer);
  compare_tables(comparer);
  compare_statements(comparer);
  comparison.items = comparer.items();
  return comparison;
}

std::string counts_text(const ReportComparison& comparison) {
  std::string text;
  for (const auto& [change, name] : change_names)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", comparison.count(change), name);
  return text;
}

std::string comparison_text(const ReportComparison& comparison, std::size_t most_items) {
  std::string text = "against " + comparison.older + ": " + counts_text(comparison) + "\n";
  if (!comparison.note.empty()) text += "  " + comparison.note + "\n";
  for (std::size_t i = 0; i < std::min(most_items, comparison.items.size()); ++i) {
    const ChangedItem& item = comparison.items[i];
    text += fmt::format("  {:8}{}{}\n", name(item.change), item.what,
                        item.before.empty() ? "" : fmt::format(": {} -> {}", item.before, item.now));
  }
  if (comparison.items.size() > most_items)
    text += fmt::format("  and {} more, in the page\n", comparison.items.size() - most_items);
  return text;
}

}  // namespace nipref::verify
