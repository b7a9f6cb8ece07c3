#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include <nipref/data/table/csv.hpp>

namespace nipref::data {

/// Reads a CSV file whose lines are about cells of tables: its columns are these, of which the first three are
/// table, row (from 1) and column. Throws BadInput with file, line and column for a malformed file, other columns,
/// or two lines for one cell.
[[nodiscard]] CsvFile read_cell_lines(const std::filesystem::path& path,
                                      std::span<const std::string_view> columns);

/// The row that a line of such a file names; refused unless it is a whole number from 1.
[[nodiscard]] std::size_t row_number(const CsvFile& file, const std::vector<CsvField>& line);

}  // namespace nipref::data
