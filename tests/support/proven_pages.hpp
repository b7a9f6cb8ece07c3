#pragma once
#include <regex>

#include "support/paths.hpp"
#include "support/test.hpp"

// The tables of proven results in ref/README.md.

/// The cells of a row of a table. Cells have names between backticks.
using TableRow = std::vector<std::string>;

inline std::vector<std::string> matches_in(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it)
    found.push_back((*it)[1]);
  return found;
}

inline std::vector<std::string> names_in(const std::string& cell) { return matches_in(cell, "`([^`]+)`"); }

/// The rows of the table whose header begins with this cell.
inline std::vector<TableRow> rows_of_proven(const std::string& first_header) {
  std::ifstream page(std::filesystem::path(source_directory()) / "ref/README.md");
  std::vector<TableRow> rows;
  bool is_inside = false;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("|")) {
      is_inside = false;
    } else if (line.starts_with("| " + first_header + " |")) {
      is_inside = true;
      std::getline(page, line);  // the rule below the header
    } else if (is_inside) {
      rows.push_back(matches_in(line, R"(\| ([^|]*)(?= \|| +\|))"));
    }
  }
  return rows;
}
