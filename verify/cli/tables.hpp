#pragma once
#include <ostream>
#include <string>
#include <vector>

namespace nipref::verify {

/// What `nipref tables` was asked for.
struct TablesRequest {
  std::vector<std::string> ids;  ///< empty: all tables that can be replayed
  bool list;                     ///< only say which tables there are and what they hold
  bool json;
  bool compact;  ///< text: the summary and the cells that do not match
};

/// Writes the replay of the tables, cell by cell, or the list. Exit status: 1 if a cell is unexplained that
/// neither its own row contradicts nor known_misses.csv lists, else 0. BadInput for unknown ids.
int tables_verb(const TablesRequest& request, std::ostream& out);

}  // namespace nipref::verify
