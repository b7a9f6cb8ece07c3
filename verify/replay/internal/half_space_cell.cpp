#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <nipref/verify/replay/internal/attempts.hpp>
#include <nipref/verify/replay/internal/half_space.hpp>

namespace nipref::verify {
namespace {

constexpr double table_unit = 1e-4;
constexpr double binary = 1e-12;  ///< larger than the rounding errors of decimal numbers in double

double distance(double value, const data::Interval& range) {
  return std::max({0.0, range.lower - value, value - range.upper});
}

double last_digit(const data::TableCell& cell) {
  return cell.number->rounding.upper - cell.number->rounding.lower;
}

/// A reading with two adjacent digits exchanged that an attempt gives, in words; empty if there is none.
std::string exchanged_digits(const data::TableCell& cell, const std::vector<Attempt>& attempts) {
  for (std::size_t place = 0; place + 1 < cell.read_as.size(); ++place) {
    std::string reading = cell.read_as;
    std::swap(reading[place], reading[place + 1]);
    const auto number = data::read_printed_number(reading, 0);
    if (!number || reading == cell.read_as) continue;
    for (const Attempt& attempt : attempts) {
      if (distance(number->value, attempt.range) <= last_digit(cell) + binary) {
        return fmt::format("two digits exchanged from {}; ", reading);
      }
    }
  }
  return "";
}

std::string units_away(const data::TableCell& cell, const Attempt& attempt) {
  return fmt::format("{:+.1f} units of the fourth decimal from {:.5f}",
                     (cell.number->value - attempt.range.middle()) / table_unit, attempt.range.middle());
}

/// The formula's number, if it does not match the cell.
std::string formula_note(const data::TableCell& printed, const HalfSpaceCell& cell) {
  std::string text = units_away(printed, cell.attempts.front()) + ", which the table's formula gives";
  for (std::size_t i = 1; i < cell.attempts.size(); ++i) {
    text += fmt::format("; {} ({})", units_away(printed, cell.attempts[i]), cell.attempts[i].how);
  }
  return text;
}

std::string unexplained_note(const data::Table& table, const HalfSpaceCell& cell) {
  const data::TableCell& printed = table.cell(cell.row, cell.column);
  std::string text = printed.erratum ? printed.erratum->reason + "; " : "";
  text += exchanged_digits(printed, cell.attempts);
  const std::string digit = one_digit(table, cell.row, cell.column, cell.attempts.front().range);
  if (!digit.empty()) text += digit + "; ";
  text += formula_note(printed, cell);
  return cell.error.empty() ? text : text + "; that formula is wrong: " + cell.error;
}

std::string joined(const std::string& first, const std::string& second) {
  return first.empty() || second.empty() ? first + second : first + "; " + second;
}

}  // namespace

ReplayedCell assess_half_space(const data::Table& table, const HalfSpaceCell& cell) {
  const data::TableCell& printed = table.cell(cell.row, cell.column);
  const double value = printed.number->value;
  const data::Interval& formula = cell.attempts.front().range;
  ReplayedCell result{cell.row, cell.column, formula.middle(), formula, Verdict::unexplained, ""};
  result.corrected = cell.corrected;
  result.exact = cell.exact;
  if (std::fabs(value - cell.corrected) <= table_unit + binary) {
    result.verdict = Verdict::match;
    return result;
  }
  const auto met = std::ranges::find_if(cell.attempts, [&](const Attempt& attempt) {
    return distance(value, attempt.range) <= last_digit(printed) + binary;
  });
  if (met != cell.attempts.end()) {
    result.value = met->range.middle();
    result.range = met->range;
    result.verdict = met->if_met;
    result.note = joined(cell.error, met->how);
  } else if (!cell.proof.empty() && !printed.is_doubtful()) {
    result.verdict = Verdict::seed_error;
    result.note = cell.proof + "; " + formula_note(printed, cell);
  } else {
    result.note = unexplained_note(table, cell);
  }
  return result;
}

}  // namespace nipref::verify
