#pragma once
#include <nipref/data/table/table.hpp>
#include <nipref/verify/replay/row.hpp>

namespace nipref::verify {

/// A cell that its row's inputs do not meet, and what the row was replayed with.
struct MissedCell {
  const data::Table& table;
  std::size_t row;
  const std::string& column;
  const data::ElasticNip& nip;
  const fast::LineLoadMethod& method;
  const RowInput& input;
};

/// A reading of the cell's print that differs in one digit and meets `range`, in words; empty if there is
/// none.
std::string one_digit(const data::Table& table, std::size_t row, const std::string& column,
                      const data::Interval& range);

/// What was tried on the cell beyond its row's inputs, and whether it helped, in words: other lengths, loads,
/// creep ratios, numbers of elements, a digit misread, another element's shear. Nothing here changes a
/// verdict. The cell must be readable.
std::string attempts(const MissedCell& missed);

}  // namespace nipref::verify
