#pragma once
#include <functional>
#include <string>

#include <nipref/data/table/table.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

/// A cell that does not match, with the inputs and the method of its row's replay.
struct MissedCell {
  const data::Table& table;
  std::size_t row;
  const std::string& column;
  const data::ElasticNip& nip;
  const fast::LineLoadMethod& method;
  const RowInput& input;
};

/// A number that differs from the print in one digit and lies in `range`, in words; empty if there is none.
std::string one_digit(const data::Table& table, std::size_t row, const std::string& column,
                      const data::Interval& range);

/// The note on a cell that is no input: why it is a misprint or has no number, or what was tried to explain it.
std::string note_on(const data::TableCell& cell, Verdict verdict, const std::function<std::string()>& tried);

/// The load that a row's replay gives for the load that the table states, in words.
std::string load_note(double replayed, double stated);

/// The attempts to explain the cell by other lengths, loads, creep ratios, numbers of elements, a misread digit or
/// the shear of another element, with their outcomes, in words. They do not change the verdict. The cell must be
/// legible.
std::string attempts(const MissedCell& missed);

}  // namespace nipref::verify
