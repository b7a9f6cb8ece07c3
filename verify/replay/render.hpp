#pragma once
#include <string>
#include <vector>

#include <nipref/data/table/index.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// The counts of verdicts, then each table with a line for each cell that does not match, or for every cell with
/// `all_cells`, with the replayed and the corrected value, and with the errors of the seed's discretisation.
std::string tables_text(const std::vector<Replay>& replays, bool all_cells);

/// The answer of `tables`, which is also part of a report.
Json tables_json(const std::vector<Replay>& replays);

/// A number in the scaling of the cell's column, with two digits more than the printed cell.
std::string scaled_text(const Replay& replay, const ReplayedCell& cell, double value);

/// The answer of `tables --list`.
std::string table_list_text(const std::vector<data::TableSummary>& summaries);
Json table_list_json(const std::vector<data::TableSummary>& summaries);

}  // namespace nipref::verify
