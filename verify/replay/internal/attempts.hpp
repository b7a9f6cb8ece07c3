#pragma once
#include <functional>
#include <initializer_list>
#include <string>

#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

/// A number that differs from the print in one digit and lies in `range`, in words; empty if there is none.
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

/// A cell that does not match, with the inputs and the method of its row's replay.
struct MissedCell {
  const data::Table& table;
  std::size_t row;
  const std::string& column;
  const data::ElasticNip& nip;
  const fast::LineLoadMethod& method;
  const RowInput& input;
};

/// The attempts to explain the cell by other lengths, loads, creep ratios, numbers of elements, a misread digit or
/// the shear of another element, with their outcomes, in words. They do not change the verdict. The cell must be
/// legible.
std::string attempts(const MissedCell& missed);

}  // namespace nipref::verify
