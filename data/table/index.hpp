#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <nipref/data/directory.hpp>
#include <nipref/data/table/table.hpp>

namespace nipref::data {

/// Ids of all tables, in the order of the seeds: thesis-III .. thesis-XXVI, then the others by name.
[[nodiscard]] std::vector<std::string> table_ids();

/// The table called `id`. BadInput if there is none.
[[nodiscard]] Table load_table_by_id(const std::string& id);

/// The id of the table that `name` means: an id, or its part after the last hyphen, in upper or lower case. A number of
/// a thesis table may be Arabic: "VII", "vii", "7". Throws BadInput if `name` means none or several, such as "3".
[[nodiscard]] std::string find_table_id(const std::string& name);

/// The counts of what a table holds. Key columns count neither as columns nor as cells.
struct TableSummary {
  std::string id;
  std::string title;
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::size_t cells = 0;          ///< rows * columns
  std::size_t empty = 0;          ///< cells where the seed shows nothing legible
  std::size_t without_value = 0;  ///< cells that cannot be read, empty or not
  std::size_t doubtful = 0;       ///< cells that stay as printed although they are doubtful
  std::array<std::size_t, erratum_kind_names.size()> errata = {};  ///< errata of cells, by ErratumKind
  std::size_t key_errata = 0;                                      ///< errata of row labels
};

[[nodiscard]] TableSummary summarize(const Table& table);

/// Summaries of all tables, in the order of table_ids.
[[nodiscard]] std::vector<TableSummary> summarize_tables();

}  // namespace nipref::data
