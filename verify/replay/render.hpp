#pragma once
#include <string>
#include <vector>

#include <nipref/data/table/index.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// Every table, a line for each cell with its replayed and its corrected value, then how far the seed's
/// discretisation is from the truth; `compact` lists only cells that do not match.
std::string tables_text(const std::vector<Replay>& replays, bool compact);

/// What `tables` answers, and what stands for it in a report.
Json tables_json(const std::vector<Replay>& replays);

/// What `tables --list` says and answers.
std::string table_list_text(const std::vector<data::TableSummary>& summaries);
Json table_list_json(const std::vector<data::TableSummary>& summaries);

}  // namespace nipref::verify
