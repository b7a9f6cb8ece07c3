#pragma once
#include <array>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/data/table/index.hpp>
#include <nipref/data/table/table.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// The values of a row, in base units, by the names of their columns.
using RowValues = std::map<std::string, double>;

/// The verdict on a cell of a seed's table.
enum class Verdict {
  input,  ///< the cell is an input of the replay; it is not judged
  match,  ///< the rounding interval of the printed number intersects the replay's interval; in the tables of
          ///< half-spaces: the printed number meets the rule of internal/half_space.hpp
  misprint,  ///< the number matches after a correction that follows from the table's own redundancy, or with one
             ///< digit changed, by which fewer than 1 in 100 cells would match by chance
  likely_misprint,  ///< the number matches with one digit changed, by chance in 1 to 20 of 100 cases; see the note
  seed_error,       ///< the seed's method or formula is wrong in a known way
  unexplained       ///< it does not match, or there is no legible number
};

inline constexpr std::array<std::string_view, 6> verdict_names{
    "input", "match", "misprint", "likely-misprint", "seed-error", "unexplained"};
std::string_view name(Verdict verdict);

/// The result of the seed's own method for one cell.
struct ReplayedCell {
  std::size_t row;  ///< from 0
  std::string column;
  double value;          ///< the value for the printed inputs, base units
  data::Interval range;  ///< the values for all inputs in their rounding intervals, base units
  Verdict verdict;
  std::string note;
  /// The correct value, base units. For a nip it is the value of the continuous contact, see correct(); for a
  /// half-space it is the value of the correct formula.
  std::optional<double> corrected = {};
  /// The correct value for the material with which the seed computed, if the seed defines another material.
  std::optional<double> corrected_with_seed_material = {};
  /// For a half-space without friction: the value of the exact elliptic contact instead of the papers' contour rule.
  std::optional<double> exact = {};
};

/// The relative deviations of a column from its true values at the same load.
struct ColumnDeviation {
  std::string column;
  double mean;     ///< the mean of the rows' absolute values
  double largest;  ///< the deviation of largest absolute value, with its sign
};

/// The errors that are due to one weakness of the seed's method.
struct Cost {
  std::string weakness;
  std::string against;  ///< the two methods that are compared, in words
  std::vector<ColumnDeviation> columns;
};

/// A replayed row of a nip's table.
struct ReplayedNip {
  RowValues values;           ///< the values for the printed inputs; the load is one of them
  int trailing_elements = 0;  ///< m2
};

struct Replay {
  data::Table table;
  std::string method;  ///< the seed's method, in words
  std::vector<ReplayedCell> cells;
  std::vector<ReplayedNip> nips = {};  ///< one for each row; none for the table of a half-space
  std::vector<Cost> costs = {};        ///< empty until correct() sets them; a half-space's replay has its own

  [[nodiscard]] std::size_t count(Verdict verdict) const;
};

/// Whether a cell is known to be unexplained. A replay with any other unexplained cell has become worse.
bool is_known_miss(const std::vector<data::KnownMiss>& known, const Replay& replay, const ReplayedCell& cell);

/// The number in the first column of a row, in base units.
double key_of_row(const data::Table& table, std::size_t row);

/// The verdict of the matching rule, which compares `range` with the rounding interval of the cell's number.
Verdict assess(const data::TableCell& cell, const data::Interval& range);

/// Ids of the tables that can be replayed.
std::vector<std::string> replayable_tables();

/// Replays one table. BadInput if there is no such table, or no replay for it.
Replay replay_table(const std::string& id);

/// Sets `corrected` in every cell of a replay to the result of the continuous contact under the row's stated load.
/// For thesis III-X the contact has the replay's material constants and is accurate to 1e-9; with full friction its
/// creep ratio is its own, which need not be the one that the thesis chose. For thesis XI-XXVI see corrected.cpp.
/// Also sets `costs`: for thesis III-X the deviations of the replay's L, d0 and p_max from the continuous contact under
/// the replay's own load. Leaves the replay of a half-space's table unchanged, because that has both already.
void correct(Replay& replay);

/// The deviations of these columns of `rows` from the same columns of `truth`.
std::vector<ColumnDeviation> deviations(std::initializer_list<const char*> columns,
                                        const std::vector<RowValues>& rows,
                                        const std::vector<RowValues>& truth);

/// The answer of `tables`, also a part of a report. Its text shows all cells, or only those that do not match.
Json tables_json(const std::vector<Replay>& replays, bool all_cells = false);

/// A list of the errors that each weakness of the seed's method causes.
Json cost_list_json(const Replay& replay);
Json column_json(const ColumnDeviation& column);

/// A number in the scaling of the cell's column, with two digits more than the printed cell.
std::string scaled_text(const Replay& replay, const ReplayedCell& cell, double value);

/// The answer of `tables --list`.
Json table_list_json(const std::vector<data::TableSummary>& summaries);

}  // namespace nipref::verify
