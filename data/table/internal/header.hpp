#pragma once
#include <nipref/data/table/csv.hpp>
#include <nipref/data/table/table.hpp>

namespace nipref::data {

/// The comment lines of a table's file as a Table without rows:
///   title: TEXT            source: FILE            after: WORDS            before: WORDS       (each once)
///   parameter: NAME = NUMBER UNIT; MEANING
///   key: NAME; UNIT; MEANING
///   column: NAME; SCALE; UNIT; MEANING             SCALE is 1 or 1eN: the printed number is value * SCALE
/// Throws BadInput with file, line and column for anything else, for a missing or repeated line, and for a
/// repeated parameter or column.
[[nodiscard]] Table read_table_header(const CsvFile& file);

}  // namespace nipref::data
