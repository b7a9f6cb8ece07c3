#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "data/table_index.hpp"
#include "verify/replay.hpp"

namespace nipref::verify {

/// Every table as printed, with the replayed value below each cell; `compact` leaves that out and lists only
/// cells that do not match.
std::string tables_text(const std::vector<Replay>& replays, bool compact);

/// {"tables": [{id, cells: [...]}], "summary": {cells, match, misprint, seed_error, unexplained}}
nlohmann::ordered_json tables_json(const std::vector<Replay>& replays);

std::string table_list_text(const std::vector<data::TableSummary>& summaries);
nlohmann::ordered_json table_list_json(const std::vector<data::TableSummary>& summaries);

}  // namespace nipref::verify
