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

/// {"tables": [{id, method, discretisation: {L: {mean, largest}, ...}, cells: [...]}], "summary": {cells,
/// match, misprint, seed_error, unexplained, without_number}}; without_number counts what of the unexplained
/// is not legible. Deviations are relative.
Json tables_json(const std::vector<Replay>& replays);

std::string table_list_text(const std::vector<data::TableSummary>& summaries);
Json table_list_json(const std::vector<data::TableSummary>& summaries);

}  // namespace nipref::verify
