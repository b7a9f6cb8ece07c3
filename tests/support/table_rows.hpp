#pragma once
#include "support/paths.hpp"
#include "support/test.hpp"

inline std::string replaced_in(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// The cells, separated by bars, in the lines of a text file of the tests. A line that begins with a blank continues
/// the line above. Empty lines and those with # are left out. \n stands for a line break.
inline std::vector<std::vector<std::string>> table_rows(const std::string& name) {
  std::ifstream file(source_directory() + "/tests/" + name);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(' ')) {
      lines.back() += " " + line.substr(line.find_first_not_of(' '));
    } else if (!line.empty() && !line.starts_with('#')) {
      lines.push_back(line);
    }
  }
  constexpr std::string_view bar = " | ";
  std::vector<std::vector<std::string>> rows;
  for (std::string line : lines) {
    auto& row = rows.emplace_back();
    for (std::size_t at = 0; (at = line.find(bar)) != std::string::npos; line.erase(0, at + bar.size()))
      row.push_back(replaced_in(line.substr(0, at), "\\n", "\n"));
    row.push_back(replaced_in(line, "\\n", "\n"));
  }
  return rows;
}
