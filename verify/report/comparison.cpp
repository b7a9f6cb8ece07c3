#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include <nipref/verify/report/report.hpp>

namespace nipref::verify {
namespace {

using nlohmann::json;

constexpr Change all_changes[] = {Change::worse,   Change::slower,   Change::better, Change::quicker,
                                  Change::changed, Change::appeared, Change::gone};
/// In the same order, which is that of the enumeration.
constexpr std::string_view change_names[] = {"worse",   "slower", "better", "quicker",
                                             "changed", "new",    "gone"};

/// A list of a report; empty if an older program did not write it.
const json& list_at(const json& report, const std::string& path) {
  static const json none = json::array();
  const json::json_pointer pointer(path);
  return report.contains(pointer) && report.at(pointer).is_array() ? report.at(pointer) : none;
}

/// The member of a row if it is a number: infinite values are null in JSON.
std::optional<double> number_at(const json& row, const std::string& key) {
  if (!row.contains(key) || !row[key].is_number()) return std::nullopt;
  return row[key].get<double>();
}

std::string text_at(const json& row, const std::string& key) {
  if (!row.contains(key)) return "";
  return row[key].is_string() ? row[key].get<std::string>() : row[key].dump();
}

/// A member of a row that is compared with that of the older report, and the changes that a smaller and a larger number
/// mean. A text that has become "true" counts as larger.
struct Column {
  std::string key;
  std::string title;  ///< after the name of the row
  Change smaller, larger;
  double differs = 0;                 ///< the ratio above which two numbers differ; 0: texts are compared
  const char* where_equal = nullptr;  ///< compared only where this member of both rows is the same
};

Column verdict_column(const std::string& key) { return {key, ", " + key, Change::worse, Change::better}; }

/// A list of the report, the members that identify its rows, and the members that are compared, up to the first text that
/// has changed.
struct Part {
  const char* path;
  const char* name;
  std::vector<const char*> keys;
  std::vector<Column> columns;
};

const std::vector<Part>& parts() {
  using enum Change;
  static const std::vector<Part> all{
      {"/audit/rows",
       "audit",
       {"quantity"},
       {verdict_column("passed"), {"max_error_ulp", ", largest error, ulp", better, worse, 1.1, "points"}}},
      {"/audit/scenes",
       "random contacts",
       {"kind"},
       {verdict_column("passed"),
        {"median_overestimate", ", statement over error, median", better, worse, 1.1, "scenes"}}},
      {"/audit/contacts",
       "hard case",
       {"system", "length_over_thickness", "poisson", "unknowns"},
       {verdict_column("passed")}},
      {"/bench/times/ratios", "speed,", {"what"}, {{"ratio", "", slower, quicker, 1.25}}},
      {"/bench/error_ratios", "error,", {"what"}, {verdict_column("met")}},
      {"/summary/tables",
       "table",
       {"id"},
       {{"match", ", cells: match", worse, better, 1},
        {"misprint", ", cells: misprint", changed, changed, 1},
        {"likely_misprint", ", cells: likely-misprint", changed, changed, 1},
        {"seed_error", ", cells: seed-error", changed, changed, 1},
        {"unexplained", ", cells: unexplained", better, worse, 1}}},
      {"/claims", "claim", {"id"}, {{"verdict", "", changed, changed}}},
      {"/limits", "limit", {"name"}, {verdict_column("approached")}},
      {"/errata", "erratum", {"id"}, {verdict_column("settled")}},
      {"/golden", "golden", {"quantity"}, {verdict_column("passed")}}};
  return all;
}

std::map<std::string, const json*> by_name(const json& rows, const std::vector<const char*>& keys) {
  std::map<std::string, const json*> named;
  for (const json& row : rows) {
    std::string id;
    for (const char* key : keys) id += (id.empty() ? "" : ", ") + text_at(row, key);
    named.emplace(id, &row);
  }
  return named;
}

std::optional<ChangedItem> change_of(const Column& column, const std::string& row, const json& before,
                                     const json& now) {
  const std::string what = row + column.title;
  if (column.differs == 0) {
    const std::string was = text_at(before, column.key), is = text_at(now, column.key);
    if (was == is) return {};
    return ChangedItem{is == "true" ? column.larger : column.smaller, what, was, is};
  }
  const auto was = number_at(before, column.key), is = number_at(now, column.key);
  if (!was || !is || std::max(*was, *is) <= column.differs * std::min(*was, *is)) return {};
  const int digits = column.smaller == Change::slower ? 3 : 4;
  return ChangedItem{*is < *was ? column.smaller : column.larger, what, fmt::format("{:.{}g}", *was, digits),
                     fmt::format("{:.{}g}", *is, digits)};
}

/// Adds the changes in the rows of a part, new rows and rows that are gone. Returns the number of rows whose numbers were
/// found at other points.
std::size_t compare(const Part& part, const json& older, const json& newer, std::vector<ChangedItem>& items) {
  const auto before = by_name(list_at(older, part.path), part.keys),
             now = by_name(list_at(newer, part.path), part.keys);
  const std::string name = std::string(part.name) + " ";
  if (!older.contains(json::json_pointer(part.path)) && !now.empty()) {
    items.push_back({Change::appeared,
                     fmt::format("{}: all {}, which the older report does not have", part.name, now.size()),
                     "", ""});
    return 0;
  }
  std::size_t of_other_points = 0;
  for (const auto& [id, row] : now) {
    const auto old = before.find(id);
    if (old == before.end()) {
      items.push_back({Change::appeared, name + id, "", ""});
      continue;
    }
    for (const Column& column : part.columns) {
      const bool comparable = column.where_equal == nullptr ||
                              text_at(*old->second, column.where_equal) == text_at(*row, column.where_equal);
      of_other_points += !comparable;
      const auto found =
          comparable ? change_of(column, name + id, *old->second, *row) : std::optional<ChangedItem>();
      if (found) items.push_back(*found);
      if (found && column.differs == 0) break;
    }
  }
  for (const auto& [id, row] : before) {
    if (!now.contains(id)) items.push_back({Change::gone, name + id, "", ""});
  }
  return of_other_points;
}

std::string version_of(const json& report) {
  const json& version = report.at("nipref");
  return text_at(version, "commit").substr(0, 10) + ", " + text_at(version, "commit_date");
}

}  // namespace

std::string_view name(Change change) { return change_names[static_cast<std::size_t>(change)]; }

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
  ReportComparison comparison{version_of(before), "", {}};
  std::size_t of_other_points = 0;
  for (const Part& part : parts()) of_other_points += compare(part, before, now, comparison.items);
  std::ranges::stable_sort(comparison.items, {}, &ChangedItem::change);
  if (of_other_points > 0)
    comparison.note = fmt::format(
        "of {} quantities or kinds of contacts other points were looked at: their errors are not compared",
        of_other_points);
  return comparison;
}

namespace {

Json item_json(const ChangedItem& item) {
  return {{"change", name(item.change)},
          {"what", item.what},
          {"before", Json::unless_empty(item.before)},
          {"now", Json::unless_empty(item.now)}};
}

}  // namespace

Json comparison_json(const ReportComparison& comparison, std::size_t most_in_text) {
  const std::size_t count = comparison.items.size(), more = count - std::min(count, most_in_text);
  return {{"older", comparison.older},
          {"note", Json::unless_empty(comparison.note)},
          {"counts", json_list(all_changes,
                               [&](Change change) {
                                 return Json{{"change", name(change)}, {"count", comparison.count(change)}};
                               })},
          {"items", json_list(comparison.items, item_json)},
          {"_first", json_list(std::span(comparison.items).first(count - more), item_json)},
          {"_more", more > 0 ? Json(more) : Json()}};
}

}  // namespace nipref::verify
