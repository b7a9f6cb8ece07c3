#include <algorithm>

#include <nipref/data/table/errata.hpp>
#include <nipref/data/table/internal/cell_lines.hpp>

namespace nipref::data {
namespace {

ErratumKind kind(const CsvFile& file, const CsvField& field) {
  const auto found = std::find(erratum_kind_names.begin(), erratum_kind_names.end(), field.text);
  if (found == erratum_kind_names.end()) {
    refuse(file.path, field.position, "must be identity, trend, replay, glyph or unreadable");
  }
  return static_cast<ErratumKind>(found - erratum_kind_names.begin());
}

Erratum read_erratum(const CsvFile& file, const std::vector<CsvField>& record) {
  Erratum erratum{record[0].text, row_number(file, record), record[2].text, record[3].text,
                  record[4].text, kind(file, record[5]),    record[6].text, record[0].position};
  if (erratum.read_as.empty() && erratum.kind != ErratumKind::unreadable) {
    refuse(file.path, record[4].position, "must not be empty unless the kind is unreadable");
  }
  if (erratum.reason.empty()) refuse(file.path, record[6].position, "must give a reason");
  return erratum;
}

}  // namespace

std::string_view name(ErratumKind kind) { return erratum_kind_names[static_cast<std::size_t>(kind)]; }

std::vector<Erratum> load_errata(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 7> columns{"table",   "row",  "column", "printed",
                                                    "read_as", "kind", "reason"};
  const CsvFile file = read_cell_lines(path, columns);
  std::vector<Erratum> errata;
  for (std::size_t i = 1; i < file.records.size(); ++i) errata.push_back(read_erratum(file, file.records[i]));
  return errata;
}

}  // namespace nipref::data
