#pragma once
#include <ostream>
#include <string>
#include <vector>

#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {

/// What `nipref tables` was asked for.
struct TablesRequest {
  std::vector<std::string>
      ids;            ///< or what data::find_table_id takes for one; empty: all tables that can be replayed
  bool list;          ///< only say which tables there are and what they hold
  bool full = false;  ///< cells that match too
  bool json;
  bool quiet = false;  ///< no progress is printed
};

/// The tables of these ids, replayed and corrected; those that are finished, if the process is interrupted.
/// BadInput for unknown ids.
std::vector<Replay> replay_and_correct(const std::vector<std::string>& ids, Progress& progress);

/// True if a cell is unexplained that neither its own row contradicts nor known_misses.csv lists.
bool fall_short(const std::vector<Replay>& replays);

/// Writes the replay of the tables, cell by cell, or the list. Exit status: 1 if they fall short, else 0.
/// BadInput for unknown ids.
int tables_verb(const TablesRequest& request, std::ostream& out);

}  // namespace nipref::verify
