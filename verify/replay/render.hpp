#pragma once
#include <string>
#include <vector>

#include <nipref/data/table/index.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// The answer of `tables`, which is also part of a report. The text shows the cells that do not match, or all.
Json tables_json(const std::vector<Replay>& replays, bool all_cells = false);

/// The errors that are due to the weaknesses of the seed's method, as a list.
Json cost_list_json(const Replay& replay);
Json column_json(const ColumnDeviation& column);

/// A number in the scaling of the cell's column, with two digits more than the printed cell.
std::string scaled_text(const Replay& replay, const ReplayedCell& cell, double value);

/// The answer of `tables --list`.
Json table_list_json(const std::vector<data::TableSummary>& summaries);

}  // namespace nipref::verify
