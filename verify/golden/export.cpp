#include <bit>
#include <cctype>

#include <nipref/data/directory.hpp>
#include <nipref/data/input_file.hpp>
#include <nipref/data/table/csv.hpp>
#include <nipref/verify/golden/check.hpp>
#include <nipref/verify/golden/golden.hpp>
#include <nipref/verify/support/internal/number_text.hpp>
#include <nipref/verify/support/json.hpp>
#include <nipref/verify/support/sha256.hpp>

namespace nipref::verify {
namespace {

struct Column {
  std::string name;
  std::vector<std::string> texts;
  std::vector<double> numbers = {};  ///< empty if some text is no number

  [[nodiscard]] bool has_numbers() const { return !numbers.empty(); }

  void read_numbers() {
    for (const std::string& text : texts) {
      std::optional<double> number = number_in(text);
      if (!number) return numbers.clear();
      // Bounds are rounded upwards, so that one that underflows is not 0.
      const std::string digits = text.substr(0, text.find('e'));
      if (name.ends_with("bound") && digits.find_first_of("123456789") != std::string::npos)
        number = std::nextafter(*number, std::numeric_limits<double>::infinity());
      numbers.push_back(*number);
    }
  }
};

struct Table : GoldenHeader {
  std::string name;
  std::vector<Column> columns;
  std::size_t rows;

  explicit Table(const std::filesystem::path& path) : name(path.stem().string()) {
    const data::CsvFile csv = data::read_csv(path);
    header = header_of(csv).header;
    header.emplace_back("version", golden_version());
    rows = csv.records.size() - 1;
    for (std::size_t i = 0; i < csv.records.front().size(); ++i) {
      columns.push_back({csv.records.front()[i].text, {}});
      for (std::size_t row = 1; row <= rows; ++row) columns.back().texts.push_back(csv.records[row][i].text);
      columns.back().read_numbers();
    }
  }
};

std::string json(const Table& table) {
  Json header = Json::object(), columns = Json::object();
  for (const auto& [key, text] : table.header) header.set(key, text);
  for (const Column& column : table.columns)
    columns.set(column.name, {{"text", json_list(column.texts)},
                              {"double", column.has_numbers() ? json_list(column.numbers) : Json()}});
  return Json({{"header", header}, {"rows", table.rows}, {"columns", columns}}).text();
}

std::string identifier(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
  return name;
}

std::string cpp(const Table& table) {
  std::string text = "#pragma once\n";
  for (const auto& [key, entry] : table.header) text += fmt::format("// {}: {}\n", key, entry);
  const std::string name = identifier(table.name);
  text += fmt::format("\nnamespace nipref_golden {{\n\nstruct {}_row {{\n", name);
  for (const Column& column : table.columns)
    text +=
        fmt::format("  {}{};\n", column.has_numbers() ? "double " : "const char* ", identifier(column.name));
  text += fmt::format("}};\n\ninline constexpr {0}_row {0}[] = {{\n", name);
  for (std::size_t row = 0; row < table.rows; ++row) {
    const auto cells = mapped(table.columns, [&](const Column& column) {
      return column.has_numbers() ? fmt::format("{:a}", column.numbers[row]) : Json(column.texts[row]).line();
    });
    text += fmt::format("  {{{}}},\n", fmt::join(cells, ", "));
  }
  return text + "};\n\n}  // namespace nipref_golden\n";
}

/// NumPy's format 1.0: a structured array, whose rows are packed numbers and texts of a fixed length.
std::string npy(const Table& table) {
  static_assert(std::endian::native == std::endian::little);
  const auto length_of = [](const Column& column) {
    return std::max<std::size_t>(1, std::ranges::max(column.texts, {}, &std::string::size).size());
  };
  const auto types = mapped(table.columns, [&](const Column& column) {
    return fmt::format("('{}', '{}')", column.name,
                       column.has_numbers() ? "<f8" : fmt::format("S{}", length_of(column)));
  });
  std::string header = fmt::format("{{'descr': [{}], 'fortran_order': False, 'shape': ({},)}}",
                                   fmt::join(types, ", "), table.rows);
  constexpr std::size_t before_header = 10, alignment = 64;
  header.append(alignment - (before_header + header.size() + 1) % alignment, ' ');
  header += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += {'\1', '\0', static_cast<char>(header.size() % 256), static_cast<char>(header.size() / 256)};
  bytes += header;
  for (std::size_t row = 0; row < table.rows; ++row) {
    for (const Column& column : table.columns) {
      if (column.has_numbers()) {
        const auto raw = std::bit_cast<std::array<char, sizeof(double)>>(column.numbers[row]);
        bytes.append(raw.data(), raw.size());
      } else {
        std::string text = column.texts[row];
        text.resize(length_of(column));
        bytes += text;
      }
    }
  }
  return bytes;
}

}  // namespace

std::string golden_version() {
  const std::filesystem::path sums = data::golden_directory() / checksums_name;
  return std::filesystem::exists(sums) ? sha256(data::text_of_input_file(sums, "checksums")) : "";
}

std::string exported_golden(const std::filesystem::path& path, std::string_view format) {
  if (format == "csv")
    return fmt::format("# version: {}\n{}", golden_version(), data::text_of_input_file(path, "file"));
  const Table table(path);
  return format == "json" ? json(table) : format == "cpp" ? cpp(table) : npy(table);
}

}  // namespace nipref::verify
