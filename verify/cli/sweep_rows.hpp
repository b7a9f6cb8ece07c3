#pragma once
#include <nipref/data/scene/file.hpp>
#include <nipref/verify/catalogue/axes.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// What came of one combination of a sweep. All rows that were computed have the same columns, the others none.
struct SweepRow {
  std::vector<std::string> columns;  ///< behind those of the axes
  std::vector<Json> values;          ///< of JSON, one for each column
  std::vector<std::string> heads;    ///< of CSV where it has others
  /// Of CSV, one for each number where a column has several.
  std::vector<std::vector<std::string>> lines{{}};
  bool fell_short = false;  ///< of what was asked
  std::optional<data::BadInput> refused = {};

  /// A column of JSON alone.
  void add(const std::string& column, const Json& value) {
    columns.push_back(column);
    values.push_back(value);
  }
  /// A column of both, where CSV has one line.
  void add(const std::string& column, const Json& value, const std::string& cell) {
    add(column, value);
    lines.front().push_back(cell);
  }
};

/// What a sweep computes, and how it is answered.
struct Sweep {
  std::string verb;  ///< of the JSON answer
  AxesProduct product;
  Json members;  ///< of the JSON answer, before the rows
  /// Of a combination, from several threads at once. BadInput: it is refused.
  std::function<SweepRow(std::size_t)> row_at;
};

/// Computes a row for each combination, on all cores, and answers with them in the order of the combinations: as CSV, with a
/// column for each axis before the others and what was refused behind them; or as JSON, the same by columns. The
/// answer falls short if a row was refused or does. BadInput, the first row's, if all are refused.
VerbAnswer swept(const Sweep& sweep, const CommandLine& line);

/// What a scene sweeps over, and the command line beside it, in that order; the command line's assignment
/// stands for what the file has. One combination, of what is assigned, if there is no sweep. BadInput as axis_of
/// and AxesProduct have it.
AxesProduct swept_scenes(const data::SceneText& text, const CommandLine& line);

}  // namespace nipref::verify
