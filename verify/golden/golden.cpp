#include <nipref/data/directory.hpp>
#include <nipref/data/table/csv.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/golden/contacts.hpp>
#include <nipref/verify/support/internal/number_text.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;
using data::CsvField;

/// Appends the columns that follow those of the arguments or keys. `results` is empty for a quantity.
std::vector<std::string> columns_behind(std::vector<std::string> columns,
                                        const std::vector<std::string>& results) {
  const auto add = [&](std::initializer_list<std::string> more) { columns.insert(columns.end(), more); };
  for (const std::string& result : results) add({result, result + "_bound"});
  if (results.empty()) add({"value", "bound", "scale"});
  add({"status", "confirmed_by"});
  if (results.empty()) add({"origin"});
  return columns;
}

/// The quantity's arguments that are columns of a file. A file may lack an argument with a default, which the
/// quantity may have got after the file was written.
std::vector<Argument> arguments_in(const Quantity& quantity, const std::vector<CsvField>& names) {
  std::vector<Argument> named;
  for (const Argument& argument : written_arguments(quantity)) {
    if (!argument.default_text || std::ranges::find(names, argument.name, &CsvField::text) != names.end())
      named.push_back(argument);
  }
  return named;
}

/// A precision at which the rounding error of a decimal text is negligible against a bound of two digits.
mpfr_prec_t bits_for(const std::string& text) { return static_cast<mpfr_prec_t>(4 * text.size() + 128); }

/// Reads a decimal number; false if the text is none.
bool read_decimal(const std::string& text, ref::Float& number, mpfr_rnd_t rounding) {
  return !text.empty() && mpfr_set_str(ref::raw(number), text.c_str(), 10, rounding) == 0 &&
         mpfr_number_p(ref::raw(number)) != 0;
}

/// The point of a row whose first fields are these arguments.
Point point_of_row(const std::filesystem::path& path, const Quantity& quantity,
                   const std::vector<Argument>& named, const std::vector<CsvField>& fields) {
  // The place of the argument, or of the material or solid that contains it.
  const auto position_of = [&](const std::string& name) {
    for (std::size_t i = 0; i < named.size(); ++i)
      if (named[i].name == name) return fields[i].position;
    return fields[named.size()].position;  // where an argument that the file lacks would stand
  };
  Assignments given;
  for (std::size_t i = 0; i < named.size(); ++i) given.emplace_back(named[i].name, fields[i].text);
  try {
    given = with_material_numbers(quantity, given);
  } catch (const BadInput& error) {
    data::refuse(path, position_of(error.argument()), error.allowed());
  }
  return mapped(quantity.arguments, [&](const Argument& argument) {
    const auto text = argument_text(argument, given);
    return argument_of(
        path, argument,
        {text.value_or(argument.default_text.value_or("")), position_of(written_name(quantity, argument))});
  });
}

void check_columns(const std::filesystem::path& path, const std::vector<CsvField>& names,
                   const std::vector<std::string>& columns) {
  for (std::size_t i = 0; i < std::max(columns.size(), names.size()); ++i) {
    if (i >= columns.size())
      data::refuse(path, names[i].position, "must not be there: a row ends with the " + columns.back());
    if (i >= names.size())
      data::refuse(path, names.back().position, "must be followed by the column " + columns[i]);
    if (names[i].text != columns[i])
      data::refuse(path, names[i].position, "must be the column " + columns[i]);
  }
}

/// The text of a finite decimal number.
const std::string& decimal_of(const std::filesystem::path& path, const CsvField& field) {
  ref::Float value = ref::zero_of_bits(bits_for(field.text));
  if (!read_decimal(field.text, value, MPFR_RNDN))
    data::refuse(path, field.position, "must be a finite decimal number");
  return field.text;
}

/// Reads the fields behind the arguments or keys: the numbers with their bounds, and the columns that follow.
void read_numbers(GoldenRow& row, const std::filesystem::path& path, std::span<const CsvField> rest,
                  bool is_of_quantity) {
  const std::size_t end = rest.size() - (is_of_quantity ? 4 : 2);
  for (std::size_t at = 0; at < end; at += 2) {
    row.numbers.push_back({decimal_of(path, rest[at]), decimal_of(path, rest[at + 1])});
    if (rest[at + 1].text.front() == '-')
      data::refuse(path, rest[at + 1].position, "a bound must not be negative");
  }
  rest = rest.subspan(end);
  if (is_of_quantity) {
    row.scale = double_of(path, rest[0]);
    if (row.scale < 0) data::refuse(path, rest[0].position, "a scale must not be negative");
    row.origin = rest.back().text;
    rest = rest.subspan(1);
  }
  row.proven = rest[0].text == "proven";
  if (!row.proven && rest[0].text != "estimated")
    data::refuse(path, rest[0].position, "must be proven or estimated");
  row.confirmed_by = rest[1].text;
}

}  // namespace

Gap::Gap(const ref::Estimate& a, const ref::Estimate& b)
    : distance(ref::zero_of_bits(64)), allowed(ref::zero_of_bits(64)) {
  mpfr_sub(ref::raw(distance), ref::raw(a.value), ref::raw(b.value), MPFR_RNDA);
  mpfr_abs(ref::raw(distance), ref::raw(distance), MPFR_RNDU);
  mpfr_add(ref::raw(allowed), ref::raw(a.error), ref::raw(b.error), MPFR_RNDU);
}

bool Gap::is_covered() const { return mpfr_lessequal_p(ref::raw(distance), ref::raw(allowed)) != 0; }

bool is_small(const ref::Float& width, double scale) {
  ref::Float most = ref::zero_of_bits(64);
  mpfr_set_d(ref::raw(most), ulp_of(scale), MPFR_RNDD);
  mpfr_div_ui(ref::raw(most), ref::raw(most), 1000, MPFR_RNDD);
  return mpfr_lessequal_p(ref::raw(width), ref::raw(most)) != 0;
}

std::string upward_text(const ref::Float& number) {
  char* text = nullptr;
  if (mpfr_asprintf(&text, "%.1RUe", ref::raw(number)) < 0) throw std::bad_alloc();
  std::string result(text);
  mpfr_free_str(text);
  return result;
}

std::string bound_text(const ref::Estimate& reference) {
  if (!mpfr_zero_p(ref::raw(reference.value)) || mpfr_zero_p(ref::raw(reference.error)))
    return reference.error_text();
  return upward_text(reference.error);
}

ref::Estimate GoldenNumber::number() const {
  ref::Float number = ref::zero_of_bits(bits_for(value)), error = ref::zero_of_bits(64);
  read_decimal(value, number, MPFR_RNDN);
  read_decimal(bound, error, MPFR_RNDU);
  return {std::move(number), std::move(error), digits_beyond_double};
}

const std::string& GoldenHeader::entry(const std::string& key) const {
  if (const auto* found = item_with(header, &Assignments::value_type::first, key)) return found->second;
  throw BadInput(key, "(missing)", "must stand in the header of a golden file");
}

const Quantity& GoldenFile::quantity() const { return find_quantity(entry("quantity")); }

int GoldenHeader::digits() const { return static_cast<int>(parse_integer("digits", entry("digits"))); }

void GoldenHeader::set(const std::string& key, const std::string& text) {
  auto* const found = item_with(header, &Assignments::value_type::first, key);
  (found == nullptr ? header.emplace_back(key, "") : *found).second = text;
}

std::string GoldenHeader::header_text() const {
  std::string text;
  for (const auto& [key, value] : header) text += fmt::format("# {}: {}\n", key, value);
  return text;
}

GoldenHeader header_of(const data::CsvFile& csv) {
  GoldenHeader read;
  for (const CsvField& comment : csv.comments) {
    const std::size_t colon = comment.text.find(": ");
    if (colon == std::string::npos) data::refuse(csv.path, comment.position, "must be '# key: text'");
    read.header.emplace_back(comment.text.substr(0, colon), comment.text.substr(colon + 2));
  }
  return read;
}

double double_of(const std::filesystem::path& path, const CsvField& field, bool may_be_none) {
  const std::string text = trimmed(field.text);
  const std::optional<double> number = number_in(text);
  if (!number || (!may_be_none && !std::isfinite(*number)))
    data::refuse(path, field.position,
                 text.find(',') != std::string::npos ? "must have a decimal point, not a comma"
                 : may_be_none                       ? "must be a number, inf or nan"
                                                     : "must be a finite number");
  return *number;
}

double argument_of(const std::filesystem::path& path, const Argument& argument, const CsvField& field) {
  if (argument.kind != ArgumentKind::choice) return double_of(path, field);
  const auto found = std::ranges::find(argument.choices, trimmed(field.text));
  if (found == argument.choices.end()) data::refuse(path, field.position, "must be " + domain(argument));
  return static_cast<double>(found - argument.choices.begin());
}

GoldenRow golden_row(const Quantity& quantity, const Point& point, const ref::Estimate& reference) {
  return {point,
          {},
          {{reference.value_text(), bound_text(reference)}},
          reference.proven,
          "",
          std::max(std::fabs(reference.to_double()), quantity.envelope(point))};
}

std::string golden_text(const GoldenFile& file) {
  const Quantity* const quantity = file.results.empty() ? &file.quantity() : nullptr;
  if (quantity == nullptr && file.rows.empty()) return file.header_text();
  const auto first = quantity != nullptr ? mapped(written_arguments(*quantity), &Argument::name)
                                         : mapped(file.rows.front().keys, &Assignments::value_type::first);
  std::string text =
      fmt::format("{}{}\n", file.header_text(), fmt::join(columns_behind(first, file.results), ","));
  const auto exact = [](double x) { return fmt::format("{:a}", x); };
  for (const GoldenRow& row : file.rows) {
    for (const auto& [name, value] :
         quantity != nullptr ? written_point(*quantity, row.arguments, exact) : row.keys)
      text += csv_field(value) + ",";
    for (const auto& [value, bound] : row.numbers) text += fmt::format("{},{},", value, bound);
    if (quantity != nullptr) text += fmt::format("{},", row.scale);
    text += fmt::format("{},{}", row.proven ? "proven" : "estimated", row.confirmed_by);
    text += (quantity != nullptr ? "," + row.origin : "") + "\n";
  }
  return text;
}

GoldenFile read_golden(const std::filesystem::path& path) {
  const data::CsvFile csv = data::read_csv(path);
  GoldenFile file{header_of(csv), {}};
  const std::string& of = file.entry("quantity");
  const bool of_contacts = is_contact_kind(of);
  const std::vector<CsvField>& names = csv.records.front();
  const auto named = of_contacts ? std::vector<Argument>() : arguments_in(file.quantity(), names);
  const auto first = of_contacts ? contact_keys(of) : mapped(named, &Argument::name);
  if (of_contacts) file.results = contact_results(of);
  static_cast<void>(file.digits());
  check_columns(path, names, columns_behind(first, file.results));
  for (const std::vector<CsvField>& fields : std::span(csv.records).subspan(1)) {
    GoldenRow& row = file.rows.emplace_back();
    if (!of_contacts) row.arguments = point_of_row(path, file.quantity(), named, fields);
    for (std::size_t i = 0; of_contacts && i < first.size(); ++i)
      row.keys.emplace_back(first[i], fields[i].text);
    read_numbers(row, path, std::span(fields).subspan(first.size()), !of_contacts);
  }
  return file;
}

std::filesystem::path golden_path(std::string_view name) {
  return data::golden_directory() / fmt::format("{}.csv", name);
}

}  // namespace nipref::verify
