#pragma once
#include <initializer_list>

#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// What a cell would be with any digit in one of its places.
struct Reading {
  std::string text;
  std::ptrdiff_t digits_behind;  ///< behind that place
  data::Interval rounding;
};

/// All such readings of a cell, those of the last place first.
std::vector<Reading> one_digit_readings(const data::Table& table, std::size_t row, const std::string& column);

/// The first of them that lies in `range`, in words; empty if there is none.
std::string one_digit(const data::Table& table, std::size_t row, const std::string& column,
                      const data::Interval& range);

/// The outcomes of several attempts, in words; those without any are left out.
std::string all_outcomes(std::initializer_list<std::string> outcomes);

/// The load that a row's replay gives for the load that the table states, in words.
std::string load_note(double replayed, double stated);

/// The input that would give the value `goal`, by linear extrapolation from the values at the ends of its interval.
double input_for(double goal, const data::Interval& input, double at_lower, double at_upper);

/// Judges a cell by the chance that its reading meets `range`: below 1 % it is a misprint, up to 20 % a likely one.
/// The reading is that of an erratum of the kind replay, whose cell its table proves wrong: a
/// last digit is then one of ten; a seed_error stays one. Or it is any other digit in one place, if the cell is unexplained; its last digit
/// can always be met.
void judge_reading(const data::Table& table, ReplayedCell& cell, const data::Interval& range);

/// The lengths that some columns of a row ask for, each of them the range for one of the row's printed numbers.
struct LengthWitness {
  std::string column;
  data::Interval length;
};

/// The chance that columns which have nothing to do with each other agree on a length: the product of (w1 + wi)/unit, with
/// w1 the width of the narrowest, wi of each other, and the unit of the digit that is in doubt. 1 if they do not agree.
double chance_of_agreement(std::vector<LengthWitness> witnesses, double unit);

/// What d0, d1 or d2 (the narrowest), p_max, creep and muR of a row ask of its length `read_as`. `at` gives the row for a
/// length.
std::vector<LengthWitness> witnesses_of_length(const data::Table& table, std::size_t row,
                                               const data::Interval& read_as,
                                               const std::function<RowValues(double)>& at);

/// The note on a length whose erratum rests on the replay: what the row's columns ask of it, and the chance that they
/// agree. Empty for any other.
std::string agreement_on_length(const data::Table& table, std::size_t row,
                                const std::function<RowValues(double)>& at);

}  // namespace nipref::verify
