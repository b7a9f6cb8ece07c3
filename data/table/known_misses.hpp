#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace nipref::data {

/// One line of known_misses.csv: a cell that no replay meets though nothing in its table speaks against it,
/// looked into and left.
struct KnownMiss {
  std::string table;   ///< id, e.g. "thesis-VII"
  std::size_t row;     ///< from 1, in the order of the table
  std::string column;  ///< name in the table's own column line
  std::string note;    ///< what was found; may be empty
};

/// Reads table,row,column,note. Throws BadInput with file, line and column for a malformed file, a row that is no
/// whole number from 1, or two lines for one cell.
[[nodiscard]] std::vector<KnownMiss> load_known_misses(const std::filesystem::path& file);

}  // namespace nipref::data
