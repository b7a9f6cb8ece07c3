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

/// One cell. `printed` is the text of the seed, with one blank for blanks and column borders; it is empty if the seed
/// shows nothing legible there. `read_as` is the number as corrected by the erratum, if any; it is empty if the cell is
/// unreadable.
struct TableCell {
  std::string printed;
  std::string read_as;
  /// The number in base units, without the scaling of the column; empty if the cell cannot be read. The rounding
  /// interval of a key is the value itself.
  std::optional<PrintedNumber> number;
  std::optional<Erratum> erratum;

  [[nodiscard]] bool is_readable() const { return number.has_value(); }
  /// Whether the cell is readable but contradicted by its row or column, which leave more than one correction, or by
  /// other tables alone. The cell then stays as printed.
  [[nodiscard]] bool is_doubtful() const {
    return is_readable() && erratum && erratum->kind == ErratumKind::unreadable;
  }
  /// Whether the reading is the one that the replay of the cell reproduces.
  [[nodiscard]] bool rests_on_replay() const { return erratum && erratum->kind == ErratumKind::replay; }
  /// Whether a digit or more is lost. The rounding interval then covers all digits that may have stood there.
  [[nodiscard]] bool has_lost_digit() const { return read_as.find(lost_digit) != std::string::npos; }
  /// False if the seed shows nothing. Such a cell may still be readable, because its row proves the number, but a
  /// comparison with it repeats a comparison with the other cells of the row.
  [[nodiscard]] bool is_printed() const { return !printed.empty(); }
};

/// A table of a seed: what is printed, and how it is read.
class Table {
 public:
  std::string id;  ///< the file's stem, e.g. "thesis-VII"
  std::string title;
  std::string source;  ///< file name of the seed's text
  std::string after;   ///< the seed's words after which the table stands
  std::string before;  ///< the seed's words before which it stands (captions are below tables)
  std::vector<TableParameter> parameters;
  std::vector<TableColumn> columns;
  std::vector<std::vector<TableCell>> rows;

  /// Position of the column called `name`. BadInput if there is none.
  [[nodiscard]] std::size_t column_index(std::string_view name) const;
  [[nodiscard]] bool has_column(std::string_view name) const;
  /// Row counts from 0. BadInput if there is no such row or column.
  [[nodiscard]] const TableCell& cell(std::size_t row, std::string_view column) const;
  /// Throws BadInput if the table does not state the parameter.
  [[nodiscard]] const TableParameter& parameter(std::string_view name) const;
};

/// Reads one table with the errata.csv of its folder (none if there is no such file). Throws BadInput with
/// file, line and column if the file is malformed, if a cell is neither a plain number nor covered by an
/// erratum, if an erratum names a cell that is not there, or if its `printed` differs from the cell. The
/// format is described in data/tables/README.md.
[[nodiscard]] Table load_table(const std::filesystem::path& file);

}  // namespace nipref::data
