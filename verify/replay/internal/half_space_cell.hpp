#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

/// One way to a cell's number.
struct Attempt {
  data::Interval range;  ///< one number, or what the rounding of another cell leaves
  Verdict if_met;
  std::string how;  ///< the note if it is met
};

/// What is known of a cell before it is compared.
struct HalfSpaceCell {
  std::size_t row;  ///< from 0
  std::string column;
  double corrected;
  std::vector<Attempt> attempts;  ///< the first is the formula that made the table, without rounding
  std::string error;              ///< what is wrong with that formula; empty if it is right
  /// Why the printed number is wrong whatever made it; empty if nothing but the formula speaks against it.
  std::string proof = {};
  /// Without friction, of the exact elliptic contact at the same responses.
  std::optional<double> exact = {};
};

/// The verdict: `match` if the printed number is within one unit of the table's fourth decimal of the
/// corrected one (the tables have four decimals and drop trailing zeros, so that 1.21 is 1.2100); that of the
/// first attempt from which it is within one unit of its own last digit, which is `match` where the formula
/// that made the table gives the cell, be it right or wrong (the note says which), and `seed_error` where the
/// table is refuted as a whole or the cell needs another number too; `seed_error` if there is a proof;
/// otherwise `unexplained`. A cell that its table casts doubt on takes no proof: what is wrong with it is
/// more than the formula.
ReplayedCell judge_half_space(const data::Table& table, const HalfSpaceCell& cell);

}  // namespace nipref::verify
