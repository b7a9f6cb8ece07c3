#include <nlohmann/json.hpp>

#include <nipref/verify/report/report.hpp>
#include <nipref/verify/support/internal/toml_table.hpp>

namespace nipref::verify {
namespace {

using nlohmann::json;

/// The names of changes, in the order of the enumeration.
constexpr std::string_view change_names[] = {"worse",   "slower", "better", "quicker",
                                             "changed", "new",    "gone"};

/// A list in a report; empty if an older program did not write this list.
const json& list_at(const json& report, const std::string& path) {
  static const json none = json::array();
  const json::json_pointer pointer(path);
  return report.contains(pointer) && report.at(pointer).is_array() ? report.at(pointer) : none;
}

/// The member of a row if it is a number. Infinite values are null in JSON.
std::optional<double> number_at(const json& row, const std::string& key) {
  if (!row.contains(key) || !row[key].is_number()) return std::nullopt;
  return row[key].get<double>();
}

std::string text_at(const json& row, const std::string& key) {
  if (!row.contains(key)) return "";
  return row[key].is_string() ? row[key].get<std::string>() : row[key].dump();
}

Change change_named(const TomlTable& column, const std::string& key) {
  const auto named = std::ranges::find(change_names, column.text(key));
  if (named == std::end(change_names))
    column.refuse(fmt::format("must have the name of a change as {}", key));
  return static_cast<Change>(named - std::begin(change_names));
}

std::map<std::string, const json*> by_name(const json& rows, const std::vector<std::string>& keys) {
  std::map<std::string, const json*> named;
  for (const json& row : rows) {
    std::string id;
    for (const std::string& key : keys) id += (id.empty() ? "" : ", ") + text_at(row, key);
    named.emplace(id, &row);
  }
  return named;
}

/// Whether the column's members are numbers. Otherwise they are texts, of which "true" counts as larger.
bool has_numbers(const TomlTable& column) { return column.numbers.contains("differs"); }

/// The change of one member of a row, if any.
std::optional<ChangedItem> change_of(const TomlTable& column, const std::string& row, const json& before,
                                     const json& now) {
  const std::string &key = column.text("key"), what = row + column.text("title");
  const Change smaller = change_named(column, "smaller"), larger = change_named(column, "larger");
  if (!has_numbers(column)) {
    const std::string was = text_at(before, key), is = text_at(now, key);
    if (was == is) return {};
    return ChangedItem{is == "true" ? larger : smaller, what, was, is};
  }
  const auto was = number_at(before, key), is = number_at(now, key);
  const double least_ratio = column.number("differs");
  if (!was || !is || std::max(*was, *is) <= least_ratio * std::min(*was, *is)) return {};
  const int digits = smaller == Change::slower ? 3 : 4;
  return ChangedItem{*is < *was ? smaller : larger, what, fmt::format("{:.{}g}", *was, digits),
                     fmt::format("{:.{}g}", *is, digits)};
}

/// Adds the changes in the rows of a part, the new rows and the rows that are gone. Returns the number of comparisons
/// left out because their errors are of different points.
std::size_t compare(const TomlTable& part, const json& older, const json& newer,
                    std::vector<ChangedItem>& items) {
  const std::string &path = part.text("path"), name = part.text("name") + " ";
  const auto keys = part.words_of("keys");
  const auto& columns = part.list("column", {"key", "title", "smaller", "larger"}, {"differs", "of"});
  const auto before = by_name(list_at(older, path), keys), now = by_name(list_at(newer, path), keys);
  if (!older.contains(json::json_pointer(path)) && !now.empty()) {
    items.push_back(
        {Change::appeared,
         fmt::format("{}: all {}, which the older report does not have", part.text("name"), now.size()), "",
         ""});
    return 0;
  }
  std::size_t of_other_points = 0;
  for (const auto& [id, row] : now) {
    const auto old = before.find(id);
    if (old == before.end()) {
      items.push_back({Change::appeared, name + id, "", ""});
      continue;
    }
    for (const TomlTable& column : columns) {
      const std::string of = column.text_or("of", "");
      if (!of.empty() && text_at(*old->second, of) != text_at(*row, of)) {
        ++of_other_points;
        continue;
      }
      const auto found = change_of(column, name + id, *old->second, *row);
      if (found) items.push_back(*found);
      if (found && !has_numbers(column)) break;
    }
  }
  for (const auto& [id, row] : before)
    if (!now.contains(id)) items.push_back({Change::gone, name + id, "", ""});
  return of_other_points;
}

std::string version_of(const json& report) {
  const json& version = report.at("nipref");
  return text_at(version, "commit").substr(0, 10) + ", " + text_at(version, "commit_date");
}

Json item_json(const ChangedItem& item) {
  return {{"change", name(item.change)},
          {"what", item.what},
          {"before", Json::unless_empty(item.before)},
          {"now", Json::unless_empty(item.now)}};
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
  const auto& parts = statements_file("comparison.toml").list("part", {"path", "name"}, {"keys", "column"});
  for (const TomlTable& part : parts) of_other_points += compare(part, before, now, comparison.items);
  std::ranges::stable_sort(comparison.items, {}, &ChangedItem::change);
  if (of_other_points > 0)
    comparison.note = fmt::format(
        "of {} quantities or kinds of contacts other points were looked at: their errors are not compared",
        of_other_points);
  return comparison;
}

Json comparison_json(const ReportComparison& comparison, std::size_t most_in_text) {
  const std::size_t count = comparison.items.size(), more = count - std::min(count, most_in_text);
  return {
      {"older", comparison.older},
      {"note", Json::unless_empty(comparison.note)},
      {"counts",
       json_list(
           std::views::iota(0U, std::size(change_names)),
           [&](std::size_t i) {
             return Json{{"change", change_names[i]}, {"count", comparison.count(static_cast<Change>(i))}};
           })},
      {"items", json_list(comparison.items, item_json)},
      {"_first", json_list(std::span(comparison.items).first(count - more), item_json)},
      {"_more", more > 0 ? Json(more) : Json()}};
}

}  // namespace nipref::verify
