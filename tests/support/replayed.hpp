#pragma once
#include <nipref/verify/replay/replay.hpp>

#include "support/test.hpp"

/// The result of verify::replay_table, which is computed once for each table in all tests.
inline const nipref::verify::Replay& replayed(const std::string& id) {
  static std::map<std::string, nipref::verify::Replay> all;
  const auto found = all.find(id);
  return found != all.end() ? found->second : all.emplace(id, nipref::verify::replay_table(id)).first->second;
}

inline const nipref::verify::ReplayedCell& cell_of(const nipref::verify::Replay& replay, std::size_t row,
                                                   const std::string& column) {
  return *std::ranges::find_if(replay.cells, [&](const nipref::verify::ReplayedCell& cell) {
    return cell.row == row && cell.column == column;
  });
}
