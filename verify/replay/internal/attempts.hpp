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

/// The note on a cell that is no input: why it is a misprint or has no number, or what was tried to explain it.
std::string note_on(const data::TableCell& cell, Verdict verdict, const std::function<std::string()>& tried);

/// The outcomes of several attempts, in words; those without any are left out.
std::string all_outcomes(std::initializer_list<std::string> outcomes);

/// The load that a row's replay gives for the load that the table states, in words.
std::string load_note(double replayed, double stated);

/// The input that would give the value `goal`, by linear extrapolation from the values at the ends of its interval.
double input_for(double goal, const data::Interval& input, double at_lower, double at_upper);

}  // namespace nipref::verify
