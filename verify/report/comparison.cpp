#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include <nipref/verify/report/comparison.hpp>

namespace nipref::verify {
namespace {

using nlohmann::json;

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

/// How a value of a row is compared with the older one.
enum class Measure {
  verdict,  ///< true is good
  word,     ///< neither is better
  error,    ///< smaller is better
  speed,    ///< a ratio to the time of others: larger is quicker
  cells     ///< how many of a table's cells have each verdict
};

struct Column {
  const char* key;
  Measure measure;
  const char* title = "";             ///< after the name of the row
  double differs = 1;                 ///< numbers do whose ratio is larger
  const char* where_equal = nullptr;  ///< compared only where this member of both rows is the same
};

/// A list of the report, what identifies its rows, and what is compared: a row ends at the first column that has changed.
struct Part {
  const char* path;
  const char* name;
  std::vector<const char*> keys;
  std::vector<Column> columns;
};

const std::vector<Part>& parts() {
  static const std::vector<Part> all{
      {"/audit/rows",
       "audit",
       {"quantity"},
       {{"kept", Measure::verdict, ", kept"},
        {"max_error_ulp", Measure::error, ", largest error, ulp", 1.1, "points"}}},
      {"/audit/scenes",
       "random contacts",
       {"kind"},
       {{"kept", Measure::verdict, ", kept"},
        {"median_overestimate", Measure::error, ", statement over error, median", 1.1, "scenes"}}},
      {"/audit/contacts",
       "hard case",
       {"system", "length_over_thickness", "poisson", "unknowns"},
       {{"kept", Measure::verdict, ", kept"}}},
      {"/bench/times/ratios", "speed,", {"what"}, {{"ratio", Measure::speed, "", 1.25}}},
      {"/bench/error_ratios", "error,", {"what"}, {{"met", Measure::verdict, ", met"}}},
      {"/tables/tables", "table", {"id"}, {{"cells", Measure::cells, ", cells: "}}},
      {"/claims", "claim", {"id"}, {{"verdict", Measure::word}}},
      {"/limits", "limit", {"name"}, {{"approached", Measure::verdict, ", approached"}}},
      {"/errata", "erratum", {"id"}, {{"settled", Measure::verdict, ", settled"}}},
      {"/golden", "golden", {"quantity"}, {{"kept", Measure::verdict, ", kept"}}}};
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

long cells_with(const json& table, const char* verdict) {
  return std::ranges::count_if(list_at(table, "/cells"),
                               [&](const json& cell) { return text_at(cell, "verdict") == verdict; });
}

/// Matches are good, what is unexplained is not; the others are neither.
std::vector<ChangedItem> changed_cells(const std::string& what, const json& before, const json& now) {
  std::vector<ChangedItem> items;
  for (const char* verdict : {"match", "misprint", "seed-error", "unexplained"}) {
    const long was = cells_with(before, verdict), is = cells_with(now, verdict);
    const std::string_view name = verdict;
    const bool is_judged = name == "match" || name == "unexplained";
    const Change change = !is_judged                        ? Change::changed
                          : (name == "match") == (is > was) ? Change::better
                                                            : Change::worse;
    if (was != is) items.push_back({change, what + verdict, std::to_string(was), std::to_string(is)});
  }
  return items;
}

std::optional<ChangedItem> changed_number(const Column& column, const std::string& what, const json& before,
                                          const json& now) {
  const auto was = number_at(before, column.key), is = number_at(now, column.key);
  if (!was || !is || std::max(*was, *is) <= column.differs * std::min(*was, *is)) return std::nullopt;
  const bool is_speed = column.measure == Measure::speed;
  const Change change = is_speed ? (*is < *was ? Change::slower : Change::quicker)
                                 : (*is < *was ? Change::better : Change::worse);
  const int digits = is_speed ? 3 : 4;
  return ChangedItem{change, what, fmt::format("{:.{}g}", *was, digits), fmt::format("{:.{}g}", *is, digits)};
}

/// What a column has to say of two rows.
std::vector<ChangedItem> changed(const Column& column, const std::string& row, const json& before,
                                 const json& now) {
  const std::string what = row + column.title, was = text_at(before, column.key),
                    is = text_at(now, column.key);
  switch (column.measure) {
    case Measure::verdict:
    case Measure::word: {
      const Change change = column.measure == Measure::word ? Change::changed
                            : is == "true"                  ? Change::better
                                                            : Change::worse;
      return was == is ? std::vector<ChangedItem>{} : std::vector{ChangedItem{change, what, was, is}};
    }
    case Measure::cells:
      return changed_cells(what, before, now);
    default: {
      const auto item = changed_number(column, what, before, now);
      return item ? std::vector{*item} : std::vector<ChangedItem>{};
    }
  }
}

/// Adds what has changed in the rows of a part, and which are new or gone. Gives the number of rows with numbers that are of
/// other points.
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
          comparable ? changed(column, name + id, *old->second, *row) : std::vector<ChangedItem>{};
      items.insert(items.end(), found.begin(), found.end());
      if (!found.empty()) break;
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

/// "2 worse, 0 slower, 1 better, ..."
std::string counts_text(const ReportComparison& comparison) {
  std::string text;
  for (const auto& [change, name] : change_names)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", comparison.count(change), name);
  return text;
}

}  // namespace

Json comparison_json(const ReportComparison& comparison) {
  return {
      {"older", comparison.older},
      {"note", Json::unless_empty(comparison.note)},
      {"counts", json_list(change_names,
                           [&](const auto& named) {
                             return Json{{"change", named.second}, {"count", comparison.count(named.first)}};
                           })},
      {"items", json_list(comparison.items, [](const ChangedItem& item) {
         return Json{{"change", name(item.change)},
                     {"what", item.what},
                     {"before", Json::unless_empty(item.before)},
                     {"now", Json::unless_empty(item.now)}};
       })}};
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
