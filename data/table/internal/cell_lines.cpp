#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <tuple>

#include <nipref/data/table/internal/cell_lines.hpp>

namespace nipref::data {

CsvFile read_cell_lines(const std::filesystem::path& path, std::span<const std::string_view> columns) {
  CsvFile file = read_csv(path);
  if (!std::ranges::equal(file.records.front(), columns, {}, &CsvField::text))
    refuse(path, file.records.front().front().position, fmt::format("must be {}", fmt::join(columns, ",")));
  std::set<std::tuple<std::string, std::size_t, std::string>> seen;
  for (std::size_t i = 1; i < file.records.size(); ++i) {
    const std::vector<CsvField>& line = file.records[i];
    if (!seen.emplace(line[0].text, row_number(file, line), line[2].text).second)
      refuse(path, line[0].position, "must be the only line for its cell");
  }
  return file;
}

std::size_t row_number(const CsvFile& file, const std::vector<CsvField>& line) {
  const CsvField& field = line[1];
  std::size_t row = 0;
  const char* const end = field.text.data() + field.text.size();
  const auto [stop, error] = std::from_chars(field.text.data(), end, row);
  if (error != std::errc{} || stop != end || row == 0)
    refuse(file.path, field.position, "must be a row number from 1");
  return row;
}

}  // namespace nipref::data
