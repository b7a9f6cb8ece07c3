#pragma once
#include <string>
#include <vector>

#include <nipref/data/table/index.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// Counts of verdicts; then every table, a line for each cell that does not match, or for `all_cells`, with its replayed
/// and its corrected value, and how far the seed's discretisation is from the truth.
std::string tables_text(const std::vector<Replay>& replays, bool all_cells);

/// What `tables` answers, and what stands for it in a report.
Json tables_json(const std::vector<Replay>& replays);

/// A number of a cell's column, in the scaling that it is printed in, with two digits more than the printed cell.
std::string scaled_text(const Replay& replay, const ReplayedCell& cell, double value);

/// What `tables --list` says and answers.
std::string table_list_text(const std::vector<data::TableSummary>& summaries);
Json table_list_json(const std::vector<data::TableSummary>& summaries);

}  // namespace nipref::verify
