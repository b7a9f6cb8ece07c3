#pragma once
#include <initializer_list>

#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// A cell's text with one digit replaced.
struct Reading {
  std::string text;
  std::ptrdiff_t digits_behind;  ///< the number of digits behind the replaced one
  data::Interval rounding;
};

/// All readings of a cell with any digit in one place, beginning with the last place.
std::vector<Reading> one_digit_readings(const data::Table& table, std::size_t row, const std::string& column);

/// The first of these readings whose rounding interval meets `range`, in words; empty if there is none.
std::string one_digit(const data::Table& table, std::size_t row, const std::string& column,
                      const data::Interval& range);

/// Joins the outcomes of several attempts, in words; leaves out empty ones.
std::string all_outcomes(std::initializer_list<std::string> outcomes);

/// Compares the load of a row's replay with the load that the table states, in words.
std::string load_note(double replayed, double stated);

/// The input that would give the value `goal`, by linear extrapolation from the values at the ends of the interval.
double input_for(double goal, const data::Interval& input, double at_lower, double at_upper);

/// Judges a cell by the chance that a corrected reading meets `range`: below 1 % the cell is a misprint, up to 20 % a
/// likely misprint. The reading is that of an erratum of the kind replay, or for an unexplained cell without one, that
/// with another digit in one place.
void judge_reading(const data::Table& table, ReplayedCell& cell, const data::Interval& range);

/// The lengths for which one column of a row agrees with its printed number.
struct LengthWitness {
  std::string column;
  data::Interval length;
};

/// The chance that unrelated columns agree on a length: the product of (w1 + wi)/unit over all but the narrowest, where
/// w1 is the narrowest width, wi the width of another column and unit that of the doubtful digit. 1 if they disagree.
double chance_of_agreement(std::vector<LengthWitness> witnesses, double unit);

/// The lengths near `read_as` for which a row's printed numbers are met: one by the narrowest of d0, d1, d2 and their
/// ratios, one each by p_max, creep and muR. `at` gives the row for a length.
std::vector<LengthWitness> witnesses_of_length(const data::Table& table, std::size_t row,
                                               const data::Interval& read_as,
                                               const std::function<RowValues(double)>& at);

/// The note on a length whose erratum rests on the replay: the lengths that the row's columns give, and the chance of
/// their agreement. Empty for any other length.
std::string agreement_on_length(const data::Table& table, std::size_t row,
                                const std::function<RowValues(double)>& at);

}  // namespace nipref::verify
