#include <cctype>

#include <nipref/data/table/csv.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/golden/contacts.hpp>
#include <nipref/verify/grade/measured_points.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;
using data::CsvField;
using data::CsvFile;

constexpr auto decimal_suffix = "_decimal";
constexpr auto quantity_key = "quantity: ";
constexpr int exact_digits = 16;  // a decimal of fewer digits may be a rounded one

std::string name_in(const CsvFile& file) {
  for (const CsvField& comment : file.comments) {
    if (comment.text.starts_with(quantity_key))
      return trimmed(comment.text.substr(std::string_view(quantity_key).size()));
  }
  throw BadInput("quantity", "(missing)",
                 "must be named behind the file, or in its comment \"# quantity: NAME\"");
}

/// The number of a column in the file.
std::optional<std::size_t> place_of(const CsvFile& file, const std::string& name) {
  const auto& names = file.records.front();
  const auto found =
      std::ranges::find_if(names, [&](const CsvField& field) { return trimmed(field.text) == name; });
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

/// The columns with the exact and the decimal number of an argument.
struct ArgumentColumns {
  const Argument* argument;
  std::optional<std::size_t> exact, decimal;
};

std::vector<ArgumentColumns> argument_columns(const CsvFile& file, const Quantity& quantity) {
  std::vector<ArgumentColumns> columns;
  for (const Argument& argument : quantity.arguments) {
    columns.push_back(
        {&argument, place_of(file, argument.name), place_of(file, argument.name + decimal_suffix)});
    if (!columns.back().exact && !columns.back().decimal && !argument.default_text)
      data::refuse(
          file.path, file.records.front().front().position,
          fmt::format("must have a column {} or {}{}", argument.name, argument.name, decimal_suffix));
  }
  return columns;
}

bool is_argument(const std::string& name, const Quantity& quantity) {
  return std::ranges::any_of(quantity.arguments, [&](const Argument& argument) {
    return name == argument.name || name == argument.name + decimal_suffix;
  });
}

std::size_t value_column(const CsvFile& file, const Quantity& quantity,
                         const std::optional<std::string>& wanted) {
  if (wanted) {
    if (const auto place = place_of(file, *wanted)) return *place;
    throw BadInput("column", *wanted, "must be the name of a column of " + file.path.string());
  }
  for (const std::string& name : {std::string("value"), quantity.name})
    if (const auto place = place_of(file, name)) return *place;
  std::vector<std::size_t> others;
  const auto& names = file.records.front();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!is_argument(trimmed(names[i].text), quantity)) others.push_back(i);
  if (others.size() == 1) return others.front();
  data::refuse(file.path, names.front().position,
               fmt::format("must have the values in a column value or {}, or in one that --column names",
                           quantity.name));
}

/// The number of significant digits of a decimal number.
int significant_digits(const std::string& text) {
  const std::string mantissa = text.substr(0, text.find_first_of("eE"));
  const auto first = mantissa.find_first_of("123456789");
  if (first == std::string::npos) return exact_digits;  // 0 is exact
  return static_cast<int>(std::count_if(mantissa.begin() + static_cast<std::ptrdiff_t>(first), mantissa.end(),
                                        [](unsigned char letter) { return std::isdigit(letter) != 0; }));
}

/// Adds a row's point and value.
void add_row(MeasuredPoints& read, const CsvFile& file, const std::vector<ArgumentColumns>& columns,
             std::size_t value, const std::vector<CsvField>& record) {
  Point point;
  bool contradicts = false, is_short = false;
  for (const auto& [argument, exact, decimal] : columns) {
    const auto place = exact ? exact : decimal;
    const CsvField field =
        place ? record[*place] : CsvField{*argument->default_text, file.records.front().front().position};
    point.push_back(argument_of(file.path, *argument, field));
    if (argument->kind == ArgumentKind::choice) continue;
    const std::string text = trimmed(field.text);
    const bool is_hexadecimal = text.find_first_of("xX") != std::string::npos;
    is_short |= place && !is_hexadecimal && significant_digits(text) < exact_digits;
    contradicts |= exact && decimal && double_of(file.path, record[*decimal]) != point.back();
  }
  read.points.push_back(std::move(point));
  read.values.push_back(double_of(file.path, record[value], true));
  read.contradicting_rows += contradicts ? 1 : 0;
  read.short_rows += is_short ? 1 : 0;
}

MeasuredPoints measured_points(const CsvFile& file, const Quantity& quantity,
                               const std::optional<std::string>& column) {
  MeasuredPoints read{&quantity, {}, {}};
  const auto columns = argument_columns(file, quantity);
  const std::size_t value = value_column(file, quantity, column);
  if (file.records.size() < 2) data::refuse(file.path, {1, 1}, "must have a row of values");
  for (std::size_t i = 1; i < file.records.size(); ++i) add_row(read, file, columns, value, file.records[i]);
  return read;
}

/// Reads each result of these contacts that has a column, or only the one that is wanted.
std::vector<MeasuredPoints> measured_contacts(const CsvFile& file, const std::string& kind,
                                              const std::optional<std::string>& wanted) {
  std::vector<MeasuredPoints> all;
  std::vector<std::string> names;
  for (const Quantity& result : contact_quantities(kind)) {
    names.push_back(result.name.substr(kind.size() + 1));
    if (place_of(file, names.back()) && wanted.value_or(names.back()) == names.back())
      all.push_back(measured_points(file, result, names.back()));
  }
  for (const CsvField& head : file.records.front()) {
    const std::string name = trimmed(head.text);
    if (is_argument(name, contact_quantities(kind).front()) || std::ranges::count(names, name) > 0) continue;
    data::refuse(file.path, head.position, fmt::format("{} must be one of {}", name, fmt::join(names, ", ")));
  }
  if (all.empty())
    data::refuse(
        file.path, {1, 1},
        fmt::format("must have a column {}", wanted.value_or(fmt::format("{}", fmt::join(names, " or ")))));
  return all;
}

}  // namespace

std::string points_csv(const Quantity& quantity, const std::vector<Point>& points,
                       const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& comment : comments) text += "# " + comment + "\n";
  std::string separator;
  for (const Argument& argument : quantity.arguments) {
    text += separator + argument.name;
    separator = ",";
    if (argument.kind != ArgumentKind::choice) text += separator + argument.name + decimal_suffix;
  }
  for (const Point& point : points) {
    separator = "\n";
    for (std::size_t i = 0; i < point.size(); ++i) {
      const Argument& argument = quantity.arguments[i];
      text += argument.kind == ArgumentKind::choice
                  ? fmt::format("{}{}", separator, argument.choice(point[i]))
                  : fmt::format("{}{:a},{}", separator, point[i], point[i]);
      separator = ",";
    }
  }
  return text + "\n";
}

std::vector<MeasuredPoints> read_measured_points(const std::string& path,
                                                 const std::optional<std::string>& quantity,
                                                 const std::optional<std::string>& column) {
  const CsvFile file = data::read_csv(path == "-" ? "/dev/stdin" : path);
  const std::string name = quantity ? *quantity : name_in(file);
  if (is_contact_kind(name)) return measured_contacts(file, name, column);
  return {measured_points(file, find_quantity(name), column)};
}

}  // namespace nipref::verify
