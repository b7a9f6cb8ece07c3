#pragma once
#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <nipref/verify/catalogue/axes.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// What came of one combination of a sweep.
struct SweepRow {
  std::vector<std::string> cells;  ///< one for each column; an empty one is not known
  bool fell_short = false;         ///< of what was asked
};

/// A column behind those of the axes.
struct SweepColumn {
  std::string name;
  bool is_text;  ///< for machines too: what may not fit a double
};

/// What a sweep computes, and how its rows are written.
struct Sweep {
  std::string_view verb;  ///< of the JSON answer
  AxesProduct product;
  std::vector<SweepColumn> columns;
  Json members;  ///< of the JSON answer, before the rows
  /// Of a combination, from several threads at once. BadInput: it is refused.
  std::function<SweepRow(std::size_t)> row_at;
};

/// Computes a row for each combination, on all cores, and writes them in the order of the combinations: as CSV, with a
/// column for each axis before the others and what was refused behind them; or as JSON, the same by columns. The
/// exit status: 1 if a row was refused or fell short. BadInput, the first row's, if all are refused.
int write_sweep(const Sweep& sweep, const CommandLine& line, std::ostream& out);

}  // namespace nipref::verify
