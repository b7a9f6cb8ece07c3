#include <fmt/format.h>

#include <algorithm>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/table/internal/header.hpp>
#include <nipref/data/table/table.hpp>

namespace nipref::data {
namespace {

std::vector<Erratum> errata_of(const std::filesystem::path& errata_file, std::string_view id) {
  if (!std::filesystem::exists(errata_file)) return {};
  std::vector<Erratum> errata = load_errata(errata_file);
  std::erase_if(errata, [id](const Erratum& erratum) { return erratum.table != id; });
  return errata;
}

void check_column_line(const CsvFile& file, const std::vector<TableColumn>& columns) {
  const auto& names = file.records.front();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i < columns.size() && names[i].text == columns[i].name) continue;
    refuse(file.path, names[i].position,
           "must name the columns in the order of the '# key' and '# column' lines");
  }
  if (names.size() < columns.size())
    refuse(file.path, names.back().position, "must name every declared column");
}

std::optional<PrintedNumber> number_in(const TableColumn& column, std::string_view text) {
  if (!column.is_key) return read_printed_number(text, column.scale_exponent);
  const auto value = read_exact_number(text);
  if (!value) return std::nullopt;
  return PrintedNumber{*value, {*value, *value}};
}

std::vector<TableCell> read_row(const CsvFile& file, std::size_t record_index) {
  std::vector<TableCell> row;
  for (const CsvField& field : file.records[record_index]) row.push_back({field.text, field.text, {}, {}});
  return row;
}

void apply(const Erratum& erratum, const std::filesystem::path& errata_file, Table& table) {
  if (erratum.row > table.rows.size()) {
    refuse(errata_file, erratum.position, fmt::format("must name a row of {}", table.id));
  }
  if (!table.has_column(erratum.column)) {
    refuse(errata_file, erratum.position, fmt::format("must name a column of {}", table.id));
  }
  TableCell& cell = table.rows[erratum.row - 1][table.column_index(erratum.column)];
  if (cell.printed != erratum.printed) {
    refuse(errata_file, erratum.position,
           fmt::format("must quote the cell of {} as '{}'", table.id, cell.printed));
  }
  cell.read_as = erratum.read_as;
  cell.erratum = erratum;
}

/// Fills in the numbers, now that every cell knows what it is read as.
void read_numbers(const CsvFile& file, const std::filesystem::path& errata_file, Table& table) {
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      TableCell& cell = table.rows[r][c];
      if (cell.read_as.empty() && cell.erratum) continue;
      cell.number = number_in(table.columns[c], cell.read_as);
      if (cell.number) continue;
      if (cell.erratum) refuse(errata_file, cell.erratum->position, "must read the cell as a plain number");
      refuse(file.path, file.records[r + 1][c].position,
             "must be a plain number or have a line in errata.csv");
    }
  }
}

}  // namespace

bool Table::has_column(std::string_view name) const {
  return std::any_of(columns.begin(), columns.end(),
                     [name](const auto& column) { return column.name == name; });
}

std::size_t Table::column_index(std::string_view name) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [name](const auto& column) { return column.name == name; });
  if (found == columns.end()) throw BadInput("column", name, "must be a column of " + id);
  return static_cast<std::size_t>(found - columns.begin());
}

const TableCell& Table::cell(std::size_t row, std::string_view column) const {
  if (row >= rows.size()) {
    throw BadInput("row", std::to_string(row),
                   fmt::format("must be below the {} rows of {}", rows.size(), id));
  }
  return rows[row][column_index(column)];
}

const TableParameter& Table::parameter(std::string_view name) const {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [name](const auto& each) { return each.name == name; });
  if (found == parameters.end()) throw BadInput("parameter", name, "must be stated by " + id);
  return *found;
}

Table load_table(const std::filesystem::path& path) {
  const CsvFile file = read_csv(path);
  Table table = read_table_header(file);
  check_column_line(file, table.columns);
  for (std::size_t i = 1; i < file.records.size(); ++i) table.rows.push_back(read_row(file, i));

  const std::filesystem::path errata_file = path.parent_path() / "errata.csv";
  for (const Erratum& erratum : errata_of(errata_file, table.id)) apply(erratum, errata_file, table);
  read_numbers(file, errata_file, table);
  return table;
}

}  // namespace nipref::data
