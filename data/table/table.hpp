#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/data/table/errata.hpp>
#include <nipref/data/table/printed_number.hpp>

namespace nipref::data {

/// A quantity that is the same for the whole table, e.g. B = 1 in. Dimensionless quantities have the unit
/// "1".
struct TableParameter {
  std::string name;
  double value;
  std::string unit;
  std::string meaning;
};

/// A column of a table. A key column labels the rows; its numbers are exact and in base units as they stand.
/// A value column holds value * 10^scale_exponent, rounded to the digits printed.
struct TableColumn {
  std::string name;
  std::string unit;
  std::string meaning;
  int scale_exponent;
  bool is_key;
  /// For a column named NAME=NUMBER, e.g. "c=0.1": the number, exact.
  std::optional<double> coordinate;
};

/// One cell. `printed` is the seed's text, blanks and column borders inside it as one blank; empty if the
/// seed has nothing legible there. `read_as` is the number after the erratum, if there is one; empty if
/// unreadable.
struct TableCell {
  std::string printed;
  std::string read_as;
  /// In base units, the column's scaling undone; nothing if the cell cannot be read. The rounding interval of
  /// a key is the value itself.
  std::optional<PrintedNumber> number;
  std::optional<Erratum> erratum;

  [[nodiscard]] bool is_readable() const { return number.has_value(); }
  /// Readable, but contradicted by its row or column in a way that leaves more than one mend, or only by
  /// other tables: it stays as printed.
  [[nodiscard]] bool is_doubtful() const {
    return is_readable() && erratum && erratum->kind == ErratumKind::unreadable;
  }
  /// Whether its reading is the one that its own replay meets.
  [[nodiscard]] bool rests_on_replay() const { return erratum && erratum->kind == ErratumKind::replay; }
  /// Readable but for a digit or more: its rounding interval is that of all digits that may have stood there.
  [[nodiscard]] bool has_lost_digit() const { return read_as.find(lost_digit) != std::string::npos; }
  /// False where the seed shows nothing. Such a cell may still be readable: what its row proves is known,
  /// but a comparison with it repeats a comparison with the cells that prove it.
  [[nodiscard]] bool is_printed() const { return !printed.empty(); }
};

/// A table of a seed: what is printed, and how it is read.
class Table {
 public:
  std::string id;  ///< the file's stem, e.g. "thesis-VII"
  std::string title;
  std::string source;  ///< file name of the seed's text
  std::string after;   ///< the seed's words before the table
  std::string before;  ///< the seed's words after it (captions stand below their tables)
  std::vector<TableParameter> parameters;
  std::vector<TableColumn> columns;
  std::vector<std::vector<TableCell>> rows;

  /// Position of the column called `name`. BadInput if there is none.
  [[nodiscard]] std::size_t column_index(std::string_view name) const;
  [[nodiscard]] bool has_column(std::string_view name) const;
  /// Row counts from 0. BadInput if there is no such row or column.
  [[nodiscard]] const TableCell& cell(std::size_t row, std::string_view column) const;
  /// BadInput if the table does not state it.
  [[nodiscard]] const TableParameter& parameter(std::string_view name) const;
};

/// Reads one table with the errata.csv of its folder (none if there is no such file). Throws BadInput with
/// file, line and column if the file is malformed, if a cell is neither a plain number nor covered by an
/// erratum, if an erratum names a cell that is not there, or if its `printed` differs from the cell. The
/// format is described in data/tables/README.md.
[[nodiscard]] Table load_table(const std::filesystem::path& file);

}  // namespace nipref::data
