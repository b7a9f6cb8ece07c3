#include <algorithm>
#include <charconv>
#include <set>
#include <tuple>

#include <nipref/data/table/errata.hpp>

namespace nipref::data {
namespace {

constexpr std::array<std::string_view, 7> header{"table",   "row",  "column", "printed",
                                                 "read_as", "kind", "reason"};

bool is_header(const std::vector<CsvField>& record) {
  return std::equal(record.begin(), record.end(), header.begin(), header.end(),
                    [](const CsvField& field, std::string_view expected) { return field.text == expected; });
}

std::size_t row_number(const CsvFile& file, const CsvField& field) {
  std::size_t row = 0;
  const char* const end = field.text.data() + field.text.size();
  const auto [stop, error] = std::from_chars(field.text.data(), end, row);
  if (error != std::errc{} || stop != end || row == 0)
    refuse(file.path, field.position, "must be a row number from 1");
  return row;
}

ErratumKind kind(const CsvFile& file, const CsvField& field) {
  const auto found = std::find(erratum_kind_names.begin(), erratum_kind_names.end(), field.text);
  if (found == erratum_kind_names.end()) {
    refuse(file.path, field.position, "must be identity, trend, glyph or unreadable");
  }
  return static_cast<ErratumKind>(found - erratum_kind_names.begin());
}

Erratum read_erratum(const CsvFile& file, const std::vector<CsvField>& record) {
  Erratum erratum{record[0].text, row_number(file, record[1]), record[2].text, record[3].text,
                  record[4].text, kind(file, record[5]),       record[6].text, record[0].position};
  if (erratum.read_as.empty() && erratum.kind != ErratumKind::unreadable) {
    refuse(file.path, record[4].position, "must not be empty unless the kind is unreadable");
  }
  if (erratum.reason.empty()) refuse(file.path, record[6].position, "must give a reason");
  return erratum;
}

}  // namespace

std::string_view name(ErratumKind kind) { return erratum_kind_names[static_cast<std::size_t>(kind)]; }

std::vector<Erratum> load_errata(const std::filesystem::path& path) {
  const CsvFile file = read_csv(path);
  if (!is_header(file.records.front())) {
    refuse(path, file.records.front().front().position,
           "must be table,row,column,printed,read_as,kind,reason");
  }
  std::vector<Erratum> errata;
  std::set<std::tuple<std::string, std::size_t, std::string>> seen;
  for (std::size_t i = 1; i < file.records.size(); ++i) {
    errata.push_back(read_erratum(file, file.records[i]));
    const Erratum& latest = errata.back();
    if (!seen.emplace(latest.table, latest.row, latest.column).second) {
      refuse(path, latest.position, "must be the only line for its cell");
    }
  }
  return errata;
}

}  // namespace nipref::data
