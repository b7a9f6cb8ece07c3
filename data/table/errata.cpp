#include <nipref/data/internal/common.hpp>
#include <nipref/data/table/errata.hpp>

namespace nipref::data {
namespace {

/// The row that a line of the file names.
std::size_t row_number(const CsvFile& file, const std::vector<CsvField>& line) {
  const CsvField& field = line[1];
  std::size_t row = 0;
  const char* const end = field.text.data() + field.text.size();
  const auto [stop, error] = std::from_chars(field.text.data(), end, row);
  if (error != std::errc{} || stop != end || row == 0)
    refuse(file.path, field.position, "must be a row number from 1");
  return row;
}

/// Returns read(file, line, row) for all lines of a file about cells of tables, whose first columns are table, row and
/// column.
auto read_cell_lines(const std::filesystem::path& path, std::initializer_list<std::string_view> columns,
                     const auto& read) {
  const CsvFile file = read_csv(path);
  if (!std::ranges::equal(file.records.front(), columns, {}, &CsvField::text))
    refuse(path, file.records.front().front().position, fmt::format("must be {}", fmt::join(columns, ",")));
  std::set<std::tuple<std::string, std::size_t, std::string>> seen;
  std::vector<decltype(read(file, file.records.front(), 0))> all;
  for (const std::vector<CsvField>& line : std::span(file.records).subspan(1)) {
    const std::size_t row = row_number(file, line);
    if (!seen.emplace(line[0].text, row, line[2].text).second)
      refuse(path, line[0].position, "must be the only line for its cell");
    all.push_back(read(file, line, row));
  }
  return all;
}

ErratumKind kind_in(const CsvFile& file, const CsvField& field) {
  const auto* const found = std::ranges::find(erratum_kind_names, field.text);
  if (found == erratum_kind_names.end())
    refuse(file.path, field.position, "must be identity, trend, replay, glyph or unreadable");
  return static_cast<ErratumKind>(found - erratum_kind_names.begin());
}

}  // namespace

std::vector<Erratum> load_errata(const std::filesystem::path& path) {
  return read_cell_lines(
      path, {"table", "row", "column", "printed", "read_as", "kind", "reason"},
      [](const CsvFile& file, const std::vector<CsvField>& line, std::size_t row) {
        Erratum erratum{line[0].text,           row,          line[2].text,    line[3].text, line[4].text,
                        kind_in(file, line[5]), line[6].text, line[0].position};
        if (erratum.read_as.empty() && erratum.kind != ErratumKind::unreadable)
          refuse(file.path, line[4].position, "must not be empty unless the kind is unreadable");
        if (erratum.reason.empty()) refuse(file.path, line[6].position, "must give a reason");
        return erratum;
      });
}

std::vector<KnownMiss> load_known_misses(const std::filesystem::path& path) {
  return read_cell_lines(path, {"table", "row", "column", "note"},
                         [](const CsvFile&, const std::vector<CsvField>& line, std::size_t row) {
                           return KnownMiss{line[0].text, row, line[2].text, line[3].text};
                         });
}

}  // namespace nipref::data
