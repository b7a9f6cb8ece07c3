#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/data/table/table.hpp>
#include <nipref/verify/replay/row.hpp>

namespace nipref::verify {

/// What is made of a cell of a seed's table.
enum class Verdict {
  input,       ///< serves the replay as its input; not counted
  match,       ///< the rounding interval of the number read meets the replay's interval; in the tables of
               ///< half-spaces they are within one unit of the last digit, see internal/half_space_cell.hpp
  misprint,    ///< it does once the table's own redundancy has corrected the printed text
  seed_error,  ///< the seed's method or formula is wrong here, and how is known
  unexplained  ///< no match, or nothing to compare
};

inline constexpr std::array<std::string_view, 5> verdict_names{"input", "match", "misprint", "seed-error",
                                                               "unexplained"};
std::string_view name(Verdict verdict);

/// Result of the seed's own method for one cell.
struct ReplayedCell {
  std::size_t row;  ///< from 0
  std::string column;
  double value;          ///< at the inputs as printed, base units
  data::Interval range;  ///< as the inputs range over their rounding intervals, base units
  Verdict verdict;
  std::string note;
  std::optional<double> corrected = {};  ///< base units: of the continuous contact, see corrected.hpp;
                                         ///< of a half-space, by the right formula
  /// The same with the material that the seed computed with, where that is not the one it defines.
  std::optional<double> corrected_with_seed_material = {};
  /// Of a half-space without friction: of the exact elliptic contact, not by the papers' contour rule.
  std::optional<double> exact = {};
};

/// How far a column is from what it should be at the same load, relative to that.
struct ColumnDeviation {
  std::string column;
  double mean;     ///< of the rows' sizes
  double largest;  ///< in size, with its sign
};

/// What one weakness of the seed's method costs.
struct Cost {
  std::string weakness;
  std::string against;  ///< in words: what is compared with what
  std::vector<ColumnDeviation> columns;
};

/// A row of a nip's table as it was replayed.
struct ReplayedNip {
  RowValues values;           ///< at the inputs as printed; the load that carries the row too
  int trailing_elements = 0;  ///< m2
};

struct Replay {
  data::Table table;
  std::string method;  ///< what was replayed, in words
  std::vector<ReplayedCell> cells;
  std::vector<ReplayedNip> nips = {};  ///< one for each row; of a half-space's table none
  std::vector<Cost> costs = {};        ///< empty until corrected

  [[nodiscard]] std::size_t count(Verdict verdict) const;
};

/// The matching rule: `range` against the rounding interval of what is read in `cell`.
Verdict judge(const data::TableCell& cell, const data::Interval& range);

/// Ids of the tables that can be replayed.
std::vector<std::string> replayable_tables();

/// Replays one table. BadInput if there is no such table, or no replay for it.
Replay replay_table(const std::string& id);

}  // namespace nipref::verify
