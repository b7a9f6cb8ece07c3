#include <nipref/data/closest_name.hpp>
#include <nipref/data/internal/common.hpp>
#include <nipref/data/table/index.hpp>

namespace nipref::data {
namespace {

/// CSV files in the folder of the tables that are no tables.
constexpr std::array<std::string_view, 2> about_cells{"errata", "known_misses"};

/// Value of a Roman numeral made of I, V and X; 0 if other letters are in it.
int roman_number(std::string_view numeral) {
  int total = 0, behind = 0;
  for (const char letter : numeral | std::views::reverse) {
    const int digit = letter == 'I' ? 1 : letter == 'V' ? 5 : letter == 'X' ? 10 : 0;
    if (digit == 0) return 0;
    total += digit < behind ? -digit : digit;
    behind = digit;
  }
  return total;
}

/// The key of the order of tables: those of the thesis by number, before all others.
std::pair<int, std::string> order(const std::string& id) {
  constexpr std::string_view prefix = "thesis-";
  const int number = id.starts_with(prefix) ? roman_number(std::string_view(id).substr(prefix.size())) : 0;
  return {number > 0 ? number : 1000, id};
}

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  for (char& letter : capitals) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return capitals;
}

bool may_mean(const std::string& name, const std::string& id) {
  const std::string wanted = in_capitals(name), last = in_capitals(id.substr(id.rfind('-') + 1));
  const int number = roman_number(last);
  return wanted == in_capitals(id) || wanted == last || (number > 0 && wanted == std::to_string(number));
}

}  // namespace

std::vector<std::string> table_ids() {
  std::vector<std::string> ids;
  for (const auto& entry : std::filesystem::directory_iterator(tables_directory())) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".csv" && !std::ranges::count(about_cells, name)) ids.push_back(name);
  }
  std::sort(ids.begin(), ids.end(), [](const auto& a, const auto& b) { return order(a) < order(b); });
  return ids;
}

Table load_table_by_id(const std::string& id) {
  // The id is looked up in the list, so that it can never name a path outside the folder.
  const auto ids = table_ids();
  if (std::find(ids.begin(), ids.end(), id) == ids.end())
    throw BadInput("table", id, "must be an id that 'tables --list' shows");
  return load_table(tables_directory() / (id + ".csv"));
}

std::string find_table_id(const std::string& name) {
  const auto ids = table_ids();
  std::vector<std::string> meant;
  std::ranges::copy_if(ids, std::back_inserter(meant), [&](const auto& id) { return may_mean(name, id); });
  if (meant.size() == 1) return meant.front();
  if (!meant.empty()) throw BadInput("table", name, fmt::format("must be one of {}", fmt::join(meant, ", ")));
  throw BadInput(
      "table", name,
      did_you_mean(name, {ids.begin(), ids.end()}, 3) + "must be an id that 'tables --list' shows");
}

TableSummary summarize(const Table& table) {
  TableSummary summary{.id = table.id, .title = table.title, .rows = table.rows.size()};
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const bool is_key = table.columns[c].is_key;
    if (!is_key) ++summary.columns;
    for (const auto& row : table.rows) {
      const TableCell& cell = row[c];
      if (is_key) {
        if (cell.erratum) ++summary.key_errata;
        continue;
      }
      if (!cell.is_printed()) ++summary.empty;
      if (!cell.is_readable()) ++summary.without_value;
      if (cell.is_doubtful()) ++summary.doubtful;
      if (cell.erratum) ++summary.errata[static_cast<std::size_t>(cell.erratum->kind)];
    }
  }
  summary.cells = summary.rows * summary.columns;
  return summary;
}

std::vector<TableSummary> summarize_tables() {
  std::vector<TableSummary> summaries;
  for (const auto& id : table_ids()) summaries.push_back(summarize(load_table_by_id(id)));
  return summaries;
}

}  // namespace nipref::data
