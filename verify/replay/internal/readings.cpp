// Possible readings of a cell or a length, and the chance that one of them meets the replay.

#include <cctype>

#include <nipref/verify/replay/internal/readings.hpp>

namespace nipref::verify {
namespace {

constexpr double largest_proof = 0.01, largest_likely = 0.2;

Verdict verdict_of(double chance) {
  return chance < largest_proof     ? Verdict::misprint
         : chance <= largest_likely ? Verdict::likely_misprint
                                    : Verdict::unexplained;
}

std::string note_of(const std::string& reading, double chance, const std::string& note) {
  return fmt::format("{}, met by chance in {:.2g} of 100 such cells; {}", reading, 100 * chance, note);
}

/// The number of digits behind the first digit in which the erratum's reading differs from the printed text.
std::ptrdiff_t digits_behind_change(const data::TableCell& cell) {
  std::string printed = cell.printed, read_as = cell.read_as;
  for (std::string* text : {&printed, &read_as})
    std::erase_if(*text, [](unsigned char c) { return std::isdigit(c) == 0; });
  const auto [differs, other] = std::ranges::mismatch(printed, read_as);
  return std::ssize(read_as) - 1 - (other - read_as.begin());
}

/// The chance that a cell unrelated to the replay meets `range` if one of its digits, in a place of this unit, may be
/// changed: (width of the rounding + width of the range)/unit.
double chance_of_digit(const data::Interval& rounding, const data::Interval& range, double place_unit) {
  return (rounding.width() + range.width()) / place_unit;
}

double place_unit(const data::TableCell& cell, std::ptrdiff_t digits_behind) {
  return cell.number->rounding.width() * std::pow(10, digits_behind);
}

/// Judges an erratum's reading. The table proves the printed number wrong, so that a change of the last digit leaves
/// one choice in ten; a seed_error stays one.
void judge_erratum(const data::TableCell& printed, ReplayedCell& cell, const data::Interval& range) {
  const auto behind = std::max<std::ptrdiff_t>(1, digits_behind_change(printed));
  const double chance = chance_of_digit(printed.number->rounding, range, place_unit(printed, behind));
  if (cell.verdict == Verdict::misprint) cell.verdict = verdict_of(chance);
  cell.note = note_of(fmt::format("{} for {}", printed.printed, printed.read_as), chance, cell.note);
}

/// Explains a cell by another digit in one place, if any is likely. The last place is of no use, because some last digit
/// always meets the range.
void explain_by_one_digit(const data::Table& table, ReplayedCell& cell, const data::Interval& range) {
  const data::TableCell& printed = table.cell(cell.row, cell.column);
  for (const Reading& reading : one_digit_readings(table, cell.row, cell.column)) {
    const double chance =
        chance_of_digit(printed.number->rounding, range, place_unit(printed, reading.digits_behind));
    if (chance > largest_likely || !reading.rounding.meets(range)) continue;
    cell.verdict = verdict_of(chance);
    cell.note =
        note_of(fmt::format("{} for {}, one digit", printed.read_as, reading.text), chance, cell.note);
    return;
  }
}

}  // namespace

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

void judge_reading(const data::Table& table, ReplayedCell& cell, const data::Interval& range) {
  const data::TableCell& printed = table.cell(cell.row, cell.column);
  if (!printed.is_readable()) return;
  const bool is_wrong = cell.verdict == Verdict::misprint || cell.verdict == Verdict::seed_error;
  if (printed.rests_on_replay() && is_wrong) judge_erratum(printed, cell, range);
  if (!printed.rests_on_replay() && cell.verdict == Verdict::unexplained)
    explain_by_one_digit(table, cell, range);
}

double chance_of_agreement(std::vector<LengthWitness> witnesses, double unit) {
  if (witnesses.empty()) return 1;
  std::ranges::sort(witnesses, {}, [](const LengthWitness& witness) { return witness.length.width(); });
  const data::Interval& first = witnesses.front().length;
  double chance = 1;
  for (std::size_t i = 1; i < witnesses.size(); ++i) {
    if (!witnesses[i].length.meets(first)) return 1;
    chance *= std::min(1.0, (first.width() + witnesses[i].length.width()) / unit);
  }
  return chance;
}

std::string agreement_on_length(const data::Table& table, std::size_t row,
                                const std::function<RowValues(double)>& at) {
  const data::TableCell& cell = table.cell(row, "L");
  if (!cell.rests_on_replay()) return "";
  const auto witnesses = witnesses_of_length(table, row, cell.number->rounding, at);
  std::string names;
  for (const LengthWitness& witness : witnesses)
    names += fmt::format("{}{} ({:.6g} to {:.6g}e-3)", names.empty() ? "" : ", ", witness.column,
                         1e3 * witness.length.lower, 1e3 * witness.length.upper);
  return fmt::format("; {} for {}: {} agree on it, by chance in {:.2g} of 100 rows", cell.printed,
                     cell.read_as, names,
                     100 * chance_of_agreement(witnesses, place_unit(cell, digits_behind_change(cell))));
}

std::vector<LengthWitness> witnesses_of_length(const data::Table& table, std::size_t row,
                                               const data::Interval& read_as,
                                               const std::function<RowValues(double)>& at) {
  const data::Interval tried{read_as.lower - read_as.width(), read_as.upper + read_as.width()};
  const RowValues low = at(tried.lower), high = at(tried.upper);
  std::vector<LengthWitness> witnesses;
  for (const auto& columns : std::vector<std::vector<std::string>>{
           {"d0", "d1", "d2", "d0/B", "d1/B", "d2/B", "d1/d0", "d2/d0"}, {"p_max"}, {"creep"}, {"muR"}}) {
    std::optional<LengthWitness> narrowest;
    for (const std::string& column : columns) {
      if (!table.has_column(column)) continue;
      const data::TableCell& cell = table.cell(row, column);
      if (!cell.is_readable() || !cell.is_printed() || cell.is_doubtful()) continue;
      const auto length = [&](double value) {
        return std::lerp(tried.lower, tried.upper,
                         (value - low.at(column)) / (high.at(column) - low.at(column)));
      };
      const auto [shorter, longer] =
          std::minmax({length(cell.number->rounding.lower), length(cell.number->rounding.upper)});
      if (!narrowest || longer - shorter < narrowest->length.width()) narrowest = {column, {shorter, longer}};
    }
    if (narrowest) witnesses.push_back(*narrowest);
  }
  return witnesses;
}

}  // namespace nipref::verify
