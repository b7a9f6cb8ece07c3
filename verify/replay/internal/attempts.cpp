#include <cctype>

#include <nipref/verify/replay/internal/attempts.hpp>

namespace nipref::verify {

std::vector<Reading> one_digit_readings(const data::Table& table, std::size_t row, const std::string& name) {
  const int exponent = table.columns[table.column_index(name)].scale_exponent;
  const std::string& text = table.cell(row, name).read_as;
  std::vector<Reading> readings;
  std::ptrdiff_t digits_behind = 0;
  for (std::size_t place = text.size(); place-- > 0;) {
    if (std::isdigit(static_cast<unsigned char>(text[place])) == 0) continue;
    for (char digit = '0'; digit <= '9'; ++digit) {
      std::string reading = text;
      reading[place] = digit;
      if (const auto number = data::read_printed_number(reading, exponent))
        readings.push_back({reading, digits_behind, number->rounding});
    }
    ++digits_behind;
  }
  return readings;
}

std::string one_digit(const data::Table& table, std::size_t row, const std::string& column,
                      const data::Interval& range) {
  const auto readings = one_digit_readings(table, row, column);
  const auto met =
      std::ranges::find_if(readings, [&](const Reading& one) { return one.rounding.meets(range); });
  return met == readings.end() ? "" : "one digit from " + met->text;
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
  return input.lower + (goal - at_lower) / (at_upper - at_lower) * input.width();
}

}  // namespace nipref::verify
