#include <array>
#include <string_view>

#include <nipref/data/table/internal/cell_lines.hpp>
#include <nipref/data/table/known_misses.hpp>

namespace nipref::data {

std::vector<KnownMiss> load_known_misses(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 4> columns{"table", "row", "column", "note"};
  const CsvFile file = read_cell_lines(path, columns);
  std::vector<KnownMiss> misses;
  for (std::size_t i = 1; i < file.records.size(); ++i) {
    const std::vector<CsvField>& line = file.records[i];
    misses.push_back({line[0].text, row_number(file, line), line[2].text, line[3].text});
  }
  return misses;
}

}  // namespace nipref::data
