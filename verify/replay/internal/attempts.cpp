#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include <nipref/verify/replay/internal/attempts.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>

namespace nipref::verify {
namespace {

constexpr int most_elements_tried = 12;

const data::TableCell& cell_of(const MissedCell& missed) {
  return missed.table.cell(missed.row, missed.column);
}

bool meets(const MissedCell& missed, const data::Interval& range) {
  return cell_of(missed).number->rounding.meets(range);
}

data::Interval range_with(const MissedCell& missed, const RowInput& input,
                          const fast::LineLoadMethod& method) {
  return replay_row(missed.nip, method, input).range(missed.column);
}

std::string other_digit(const MissedCell& missed) {
  return one_digit(missed.table, missed.row, missed.column, range_with(missed, missed.input, missed.method));
}

/// The value of the input that would give the printed number; the other inputs are at the midpoints of their intervals.
/// `put` sets the input.
template <class Put>
double needed(const MissedCell& missed, const data::Interval& ends, const Put& put) {
  const auto value_at = [&](double at) {
    RowInput input = missed.input;
    input.length = data::Interval::only(input.length.middle());
    if (input.creep) input.creep = data::Interval::only(input.creep->middle());
    put(input, data::Interval::only(at));
    return replay_row(missed.nip, missed.method, input).at_centre.at(missed.column);
  };
  const double at_low = value_at(ends.lower), at_high = value_at(ends.upper);
  const data::Interval& printed = cell_of(missed).number->rounding;
  const double goal = at_low < printed.lower ? printed.lower : printed.upper;
  return input_for(goal, ends, at_low, at_high);
}

std::string needed_length(const MissedCell& missed) {
  const auto put = [](RowInput& input, const data::Interval& length) { input.length = length; };
  return fmt::format("it would take L = {:.6g}e-3", 1e3 * needed(missed, missed.input.length, put));
}

std::string needed_creep(const MissedCell& missed) {
  if (!missed.input.creep) return "";
  const auto put = [](RowInput& input, const data::Interval& creep) { input.creep = creep; };
  return fmt::format("or creep = {:.7g}e-4", 1e4 * needed(missed, *missed.input.creep, put));
}

std::string other_elements(const MissedCell& missed) {
  std::string met;
  for (int elements = 1; elements <= most_elements_tried; ++elements) {
    if (meets(missed, range_with(missed, missed.input, elements))) met += fmt::format(" {}", elements);
  }
  return met.empty() ? "no other number of elements up to 12 meets it"
                     : fmt::format("met by chance with elements a side:{}", met);
}

/// The element whose shear is closest to the printed number, unless it is the element with the largest shear.
std::string other_shear(const MissedCell& missed) {
  if (missed.column != "q_max") return "";
  const std::vector<double> shear =
      shear_of_side(missed.nip, missed.method, missed.input.length.middle(), missed.input.creep->middle());
  const double printed = cell_of(missed).number->value;
  const auto nearest =
      std::ranges::min_element(shear, {}, [&](double here) { return std::abs(here - printed); });
  if (*nearest == std::ranges::max(shear)) return "";
  return fmt::format("not the largest: element {} of {} has {:.6g}", nearest - shear.begin() + 1,
                     shear.size(), *nearest);
}

}  // namespace

std::string one_digit(const data::Table& table, std::size_t row, const std::string& name,
                      const data::Interval& range) {
  const data::TableColumn& column = table.columns[table.column_index(name)];
  const std::string& text = table.cell(row, name).read_as;
  for (std::size_t place = text.size(); place-- > 0;) {
    for (char digit = '0'; digit <= '9'; ++digit) {
      std::string reading = text;
      if (std::isdigit(static_cast<unsigned char>(reading[place])) == 0) break;
      reading[place] = digit;
      const auto number = data::read_printed_number(reading, column.scale_exponent);
      if (number && number->rounding.meets(range)) return fmt::format("one digit from {}", reading);
    }
  }
  return "";
}

std::string note_on(const data::TableCell& cell, Verdict verdict, const std::function<std::string()>& tried) {
  if (verdict == Verdict::match) return "";
  if (verdict == Verdict::misprint || !cell.is_readable())
    return cell.erratum ? cell.erratum->reason : "nothing legible";
  return cell.erratum ? cell.erratum->reason + "; " + tried() : tried();
}

std::string load_note(double replayed, double stated) {
  return fmt::format("replay's load at this length {:.4g} for {:g} ({:+.2f} %)", replayed, stated,
                     100 * (replayed / stated - 1));
}

std::string all_outcomes(std::initializer_list<std::string> outcomes) {
  std::string text;
  for (const std::string& outcome : outcomes)
    if (!outcome.empty()) text += (text.empty() ? "" : "; ") + outcome;
  return text;
}

double input_for(double goal, const data::Interval& input, double at_lower, double at_upper) {
  return input.lower + (goal - at_lower) / (at_upper - at_lower) * (input.upper - input.lower);
}

std::string attempts(const MissedCell& missed) {
  return all_outcomes({other_shear(missed), other_digit(missed), needed_length(missed), needed_creep(missed),
                       other_elements(missed)});
}

}  // namespace nipref::verify
