#include <nipref/data/internal/common.hpp>
#include <nipref/data/table/table.hpp>

namespace nipref::data {
namespace {

/// Parses a header line from the left and keeps track of the position for messages.
class HeaderLine {
 public:
  HeaderLine(const CsvFile& file, const CsvField& comment)
      : file_(file), rest_(comment.text), position_(comment.position) {}

  /// The non-empty text before `separator`, which is removed with it.
  std::string_view until(std::string_view separator) {
    const std::size_t end = rest_.find(separator);
    if (end == rest_.npos || end == 0) fail(fmt::format("must have a text and '{}' here", separator));
    const std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end + separator.size());
    position_.column += end + separator.size();
    return text;
  }

  /// All that is left, non-empty.
  std::string_view rest() const {
    if (rest_.empty()) fail("must not end here");
    return rest_;
  }

  double number_until(std::string_view separator) {
    const TextPosition start = position_;
    const auto value = read_exact_number(until(separator));
    if (!value) refuse(file_.path, start, "must be a number");
    return *value;
  }

  /// The exponent N of "1eN", 0 for "1".
  int scale_exponent_until(std::string_view separator) {
    const TextPosition start = position_;
    const std::string_view text = until(separator);
    if (text == "1") return 0;
    int exponent = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] =
        std::from_chars(text.data() + std::min<std::size_t>(2, text.size()), end, exponent);
    if (!text.starts_with("1e") || error != std::errc{} || stop != end)
      refuse(file_.path, start, "must be 1 or 1eN");
    return exponent;
  }

  [[noreturn]] void fail(std::string_view requirement) const { refuse(file_.path, position_, requirement); }

 private:
  const CsvFile& file_;
  std::string_view rest_;
  TextPosition position_;
};

std::optional<double> coordinate_in(std::string_view column_name) {
  const std::size_t equals = column_name.find('=');
  if (equals == column_name.npos) return std::nullopt;
  return read_exact_number(column_name.substr(equals + 1));
}

void set_once(std::string& text, const HeaderLine& line) {
  if (!text.empty()) line.fail("must be given once");
  text = line.rest();
}

void add_parameter(Table& table, HeaderLine& line) {
  const HeaderLine start = line;
  TableParameter parameter;
  parameter.name = line.until(" = ");
  parameter.value = line.number_until(" ");
  parameter.unit = line.until("; ");
  parameter.meaning = line.rest();
  for (const auto& other : table.parameters) {
    if (other.name == parameter.name) start.fail("must be given once");
  }
  table.parameters.push_back(parameter);
}

void add_column(Table& table, HeaderLine& line, bool is_key) {
  const HeaderLine start = line;
  TableColumn column{};
  column.name = line.until("; ");
  column.is_key = is_key;
  column.scale_exponent = is_key ? 0 : line.scale_exponent_until("; ");
  column.unit = line.until("; ");
  column.meaning = line.rest();
  column.coordinate = coordinate_in(column.name);
  if (table.has_column(column.name)) start.fail("must be given once");
  table.columns.push_back(column);
}

void read_line(Table& table, HeaderLine& line) {
  const HeaderLine start = line;
  const std::string_view keyword = line.until(": ");
  if (keyword == "title") return set_once(table.title, line);
  if (keyword == "source") return set_once(table.source, line);
  if (keyword == "after") return set_once(table.after, line);
  if (keyword == "before") return set_once(table.before, line);
  if (keyword == "parameter") return add_parameter(table, line);
  if (keyword == "key") return add_column(table, line, true);
  if (keyword == "column") return add_column(table, line, false);
  start.fail("must begin with title, source, after, before, parameter, key or column");
}

/// The comment lines of a table's file as a Table without rows:
///   title: TEXT            source: FILE            after: WORDS            before: WORDS       (each once)
///   parameter: NAME = NUMBER UNIT; MEANING
///   key: NAME; UNIT; MEANING
///   column: NAME; SCALE; UNIT; MEANING             SCALE is 1 or 1eN: the printed number is value * SCALE
/// Throws BadInput with file, line and column for anything else, for a missing or repeated line, and for a
/// repeated parameter or column.
Table read_table_header(const CsvFile& file) {
  Table table;
  table.id = file.path.stem().string();
  for (const CsvField& comment : file.comments) {
    HeaderLine line(file, comment);
    read_line(table, line);
  }
  const TextPosition end = file.records.front().front().position;
  for (const auto* text : {&table.title, &table.source, &table.after, &table.before}) {
    if (text->empty()) refuse(file.path, end, "must have title, source, after and before lines above it");
  }
  return table;
}

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

/// Sets the numbers of all cells, whose `read_as` is known.
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
  return std::ranges::count(columns, name, &TableColumn::name) > 0;
}

std::size_t Table::column_index(std::string_view name) const {
  const auto found = std::ranges::find(columns, name, &TableColumn::name);
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
  const auto found = std::ranges::find(parameters, name, &TableParameter::name);
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
