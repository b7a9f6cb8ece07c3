#pragma once
#include <ostream>

#include <nipref/data/scene/file.hpp>
#include <nipref/verify/catalogue/axes.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// What came of one combination of a sweep.
struct SweepRow {
  std::vector<std::vector<std::string>> lines;  ///< of CSV, one for each number where a column has several
  std::vector<Json> values;                     ///< of JSON, one for each column
  bool fell_short = false;                      ///< of what was asked

  /// To the row's only line.
  void add(const std::string& cell, const Json& value) {
    if (lines.empty()) lines.emplace_back();
    lines.front().push_back(cell);
    values.push_back(value);
  }
};

/// What a sweep computes, and how its rows are written.
struct Sweep {
  std::string_view verb;  ///< of the JSON answer
  AxesProduct product;
  std::vector<std::string> columns;  ///< behind those of the axes
  Json members;                      ///< of the JSON answer, before the rows
  std::vector<std::string> heads;    ///< of CSV
  /// Of a combination, from several threads at once. BadInput: it is refused.
  std::function<SweepRow(std::size_t)> row_at;
};

/// Computes a row for each combination, on all cores, and writes them in the order of the combinations: as CSV, with a
/// column for each axis before the others and what was refused behind them; or as JSON, the same by columns. The
/// exit status: 1 if a row was refused or fell short. BadInput, the first row's, if all are refused.
int write_sweep(const Sweep& sweep, const CommandLine& line, std::ostream& out);

/// What a scene sweeps over, and the command line beside it, in that order; the command line's assignment
/// stands for what the file has. One combination, of what is assigned, if there is no sweep. BadInput as axis_of
/// and AxesProduct have it.
AxesProduct swept_scenes(const data::SceneText& text, const CommandLine& line);

}  // namespace nipref::verify
