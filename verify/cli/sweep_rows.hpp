#pragma once
#include <nipref/data/scene/file.hpp>
#include <nipref/verify/catalogue/axes.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// The result of one combination of a sweep. All rows that were computed have the same columns; other rows have none.
struct SweepRow {
  std::vector<std::string> columns;  ///< names of the columns behind those of the axes
  std::vector<Json> values;          ///< values for JSON, one for each column
  std::vector<std::string> heads;    ///< names of the columns of CSV, if they are others
  /// The cells of the lines of CSV; there is a line for each number where a column has several.
  std::vector<std::vector<std::string>> lines{{}};
  bool fell_short = false;  ///< whether it misses what was asked
  std::optional<data::BadInput> refused = {};

  /// Adds a column for JSON alone.
  void add(const std::string& column, const Json& value) {
    columns.push_back(column);
    values.push_back(value);
  }
  /// Adds a column for JSON and CSV, where CSV has one line.
  void add(const std::string& column, const Json& value, const std::string& cell) {
    add(column, value);
    lines.front().push_back(cell);
  }
};

/// A sweep: what it computes, and the parts of its answer.
struct Sweep {
  std::string verb;  ///< verb in the JSON answer
  AxesProduct product;
  Json members;  ///< members of the JSON answer before the rows
  /// Computes a combination's row; called from several threads at once. BadInput for a combination that is refused.
  std::function<SweepRow(std::size_t)> row_at;
};

/// Computes a row for each combination, on all cores. The answer has the rows in the order of the combinations, as CSV
/// or, by columns, as JSON: first a column for each axis, last why a row was refused. The answer falls short if a row
/// falls short or was refused. If all rows are refused, throws the BadInput of the first row.
VerbAnswer swept(const Sweep& sweep, const CommandLine& line);

/// The combinations of the axes in the scene, followed by those in the command line. An assignment in the command line
/// replaces the scene's axis for its key. Without a sweep there is one combination, of the assigned values. BadInput as
/// from axis_of and AxesProduct.
AxesProduct swept_scenes(const data::SceneText& text, const CommandLine& line);

}  // namespace nipref::verify
