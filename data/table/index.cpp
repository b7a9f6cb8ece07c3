#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/closest_name.hpp>
#include <nipref/data/table/index.hpp>

namespace nipref::data {
namespace {

/// Files beside the tables that are none.
constexpr std::array<std::string_view, 2> about_cells{"errata", "known_misses"};

int roman_digit(char digit) {
  switch (digit) {
    case 'I':
      return 1;
    case 'V':
      return 5;
    case 'X':
      return 10;
    default:
      return 0;
  }
}

/// Value of a Roman numeral made of I, V and X; 0 if other letters are in it.
int roman_number(std::string_view numeral) {
  int total = 0;
  for (std::size_t i = 0; i < numeral.size(); ++i) {
    const int digit = roman_digit(numeral[i]);
    if (digit == 0) return 0;
    const int next = i + 1 < numeral.size() ? roman_digit(numeral[i + 1]) : 0;
    total += digit < next ? -digit : digit;
  }
  return total;
}

/// Sorts the thesis's tables by number and before all others.
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

void count_key(const Table& table, std::size_t column, TableSummary& summary) {
  for (const auto& row : table.rows) {
    if (row[column].erratum) ++summary.key_errata;
  }
}

void count_values(const Table& table, std::size_t column, TableSummary& summary) {
  ++summary.columns;
  for (const auto& row : table.rows) {
    const TableCell& cell = row[column];
    if (!cell.is_printed()) ++summary.empty;
    if (!cell.is_readable()) ++summary.without_value;
    if (cell.is_doubtful()) ++summary.doubtful;
    if (cell.erratum) ++summary.errata[static_cast<std::size_t>(cell.erratum->kind)];
  }
}

}  // namespace

std::vector<std::string> table_ids(const std::filesystem::path& directory) {
  std::vector<std::string> ids;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".csv" && !std::ranges::count(about_cells, name)) ids.push_back(name);
  }
  std::sort(ids.begin(), ids.end(), [](const auto& a, const auto& b) { return order(a) < order(b); });
  return ids;
}

Table load_table_by_id(const std::string& id, const std::filesystem::path& directory) {
  // Looked up in the list, so that an id can never name a path outside the folder.
  const auto ids = table_ids(directory);
  if (std::find(ids.begin(), ids.end(), id) == ids.end())
    throw BadInput("table", id, "must be an id that 'tables --list' shows");
  return load_table(directory / (id + ".csv"));
}

std::string find_table_id(const std::string& name, const std::filesystem::path& directory) {
  const auto ids = table_ids(directory);
  std::vector<std::string> meant;
  std::ranges::copy_if(ids, std::back_inserter(meant), [&](const auto& id) { return may_mean(name, id); });
  if (meant.size() == 1) return meant.front();
  if (!meant.empty()) throw BadInput("table", name, fmt::format("must be one of {}", fmt::join(meant, ", ")));
  throw BadInput(
      "table", name,
      did_you_mean(name, {ids.begin(), ids.end()}, 3) + "must be an id that 'tables --list' shows");
}

TableSummary summarize(const Table& table) {
  TableSummary summary{table.id, table.title, table.rows.size(), 0, 0, 0, 0, 0, {}, 0};
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (table.columns[c].is_key) {
      count_key(table, c, summary);
    } else {
      count_values(table, c, summary);
    }
  }
  summary.cells = summary.rows * summary.columns;
  return summary;
}

std::vector<TableSummary> summarize_tables(const std::filesystem::path& directory) {
  std::vector<TableSummary> summaries;
  for (const auto& id : table_ids(directory)) summaries.push_back(summarize(load_table_by_id(id, directory)));
  return summaries;
}

}  // namespace nipref::data
