#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include <nipref/data/table/internal/header.hpp>

namespace nipref::data {
namespace {

/// Takes a header line apart from the left, keeping track of the position for messages.
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

}  // namespace

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

}  // namespace nipref::data
