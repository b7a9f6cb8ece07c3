#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace nipref::data {

/// The most bytes of a line and lines of a file. The whole file is kept, in about a hundred bytes a field.
inline constexpr std::size_t longest_csv_line = 65536, most_csv_lines = 10'000'000;

/// Where something stands in a text file; both count from 1, columns in bytes.
struct TextPosition {
  std::size_t line;
  std::size_t column;
};

/// One field of a CSV record, quotes removed.
struct CsvField {
  std::string text;
  TextPosition position;
};

/// A CSV file: the comment lines before the records ("# " removed) and the records. Fields are separated by
/// commas; a field in double quotes may hold commas and doubled quotes, but no line break. Records have at
/// least one field; blank lines are refused.
struct CsvFile {
  std::filesystem::path path;
  std::vector<CsvField> comments;
  std::vector<std::vector<CsvField>> records;
};

/// Reads a whole file in one pass, so that it may be a pipe, and leaves out a byte order mark. Throws BadInput if the
/// file cannot be read (input_file.hpp). Throws BadInput naming file, line and column for an open quote, text after a
/// closing quote, a blank line, a comment below the first record, a first record whose fields are separated by
/// semicolons, or a record with more or fewer fields than the first.
[[nodiscard]] CsvFile read_csv(const std::filesystem::path& path);

/// Throws BadInput "file = FILE:LINE:COLUMN: REQUIREMENT".
[[noreturn]] void refuse(const std::filesystem::path& path, TextPosition position,
                         std::string_view requirement);

}  // namespace nipref::data
