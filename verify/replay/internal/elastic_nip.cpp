#include <nipref/data/material/seed_solids.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>
#include <nipref/verify/replay/internal/readings.hpp>

namespace nipref::verify {
namespace {

/// How a table's printed creep was rounded.
enum class CreepReading {
  rounded,        ///< to the nearest number, as everywhere in the thesis
  away_from_zero  ///< its absolute value was rounded up
};

data::Interval creep_interval(const data::PrintedNumber& printed, CreepReading reading) {
  if (reading == CreepReading::rounded) return printed.rounding;
  const double unit = printed.rounding.width();
  return printed.value < 0 ? data::Interval{printed.value, printed.value + unit}
                           : data::Interval{printed.value - unit, printed.value};
}

/// Replays the cells of one row.
class RowReplay {
 public:
  RowReplay(const data::Table& table, std::size_t row, const data::ElasticNip& nip, data::Friction friction,
            const fast::LineLoadMethod& method, CreepReading reading)
      : table_(table), row_(row), nip_(nip), method_(method), input_(read_input(friction, reading)) {
    replayed_ = replay_row(nip, method, input_);
  }

  [[nodiscard]] ReplayedNip nip() const { return {replayed_.at_centre, method_.elements_per_side}; }

  [[nodiscard]] ReplayedCell cell(const std::string& column) const {
    const data::TableCell& cell = table_.cell(row_, column);
    const data::Interval range = replayed_.range(column);
    const Verdict verdict = is_input(column) ? Verdict::input : assess(cell, range);
    ReplayedCell result{row_,  column,  replayed_.at_centre.at(column),
                        range, verdict, note(cell, column, verdict)};
    if (verdict == Verdict::unexplained && column == "q_max") explain_by_element(result);
    if (result.verdict == Verdict::unexplained)
      judge_reading(table_, result, replay_row(nip_, method_, narrowed()).range(column));
    return result;
  }

 private:
  /// Marks a cell as an error of the seed if the shear of the table's element meets it, which is not the largest here.
  void explain_by_element(ReplayedCell& largest) const {
    const int element = line_load_table(table_.id).shear_element;
    if (element == 0) return;
    const auto shear = [&](const RowInput& at) {
      return shear_of_side(nip_, method_, at.length.middle(),
                           at.creep->middle())[static_cast<std::size_t>(element - 1)];
    };
    const double middle = shear(input_);
    const auto [least, most] = std::ranges::minmax(mapped(input_.corners(), shear));
    const data::Interval range{std::min(least, middle), std::max(most, middle)};
    if (assess(table_.cell(row_, largest.column), range) == Verdict::unexplained) return;
    largest.verdict = Verdict::seed_error;
    largest.note = fmt::format(
        "not the largest shear: that of element {} of {}, {:.6g}, which is the largest in most rows of the table",
        element, method_.elements_per_side, middle);
  }

  [[nodiscard]] bool length_is_printed() const {
    const data::TableCell& length = table_.cell(row_, "L");
    return length.is_printed() && length.is_readable();
  }

  /// The length that follows from the cell L/B of the same row.
  [[nodiscard]] data::Interval length_from_ratio() const {
    const data::TableCell& ratio = table_.cell(row_, "L/B");
    if (!ratio.is_readable()) throw data::BadInput("L", ratio.printed, "or L/B must be readable");
    return ratio.number->rounding.times(nip_.sheet_thickness);
  }

  [[nodiscard]] RowInput read_input(data::Friction friction, CreepReading reading) const {
    RowInput input{length_is_printed() ? table_.cell(row_, "L").number->rounding : length_from_ratio(), {}};
    if (friction == data::Friction::none) return input;
    const data::TableCell& creep = table_.cell(row_, "creep");
    if (!creep.is_readable()) throw data::BadInput("creep", creep.printed, "must be readable");
    input.creep = creep_interval(*creep.number, reading);
    return input;
  }

  /// The input, its length as narrow as L/B has it where that is printed too.
  [[nodiscard]] RowInput narrowed() const {
    RowInput input = input_;
    const data::TableCell& ratio = table_.cell(row_, "L/B");
    if (ratio.is_readable() && !ratio.is_doubtful()) input.length = input.length.within(length_from_ratio());
    return input;
  }

  [[nodiscard]] bool is_input(const std::string& column) const {
    return column == "L" || (column == "L/B" && !length_is_printed()) ||
           (column == "creep" && input_.creep.has_value());
  }

  [[nodiscard]] std::string note(const data::TableCell& cell, const std::string& column,
                                 Verdict verdict) const {
    if (column == "L")
      return (length_is_printed() ? "" : "not legible, taken from L/B; ") +
             load_note(replayed_.at_centre.at("W"), table_.cell(row_, "W").number->value) +
             agreement_on_length(table_, row_, [&](double length) {
               return replay_row(nip_, method_, {data::Interval::only(length), input_.creep}).at_centre;
             });
    if (verdict == Verdict::input) return "";
    return note_on(cell, verdict, [&] { return attempts(column); });
  }

  /// What was tried to explain a legible cell: a misread digit, another length, creep ratio or number of elements, the
  /// shear of another element. The verdict does not depend on it.
  [[nodiscard]] std::string attempts(const std::string& column) const {
    return all_outcomes(
        {other_shear(column), one_digit(table_, row_, column, replayed_.range(column)),
         fmt::format("it would take L = {:.6g}e-3", 1e3 * needed(column, &RowInput::length)),
         input_.creep ? fmt::format("or creep = {:.7g}e-4", 1e4 * needed(column, &RowInput::creep)) : "",
         other_elements(column)});
  }

  /// The value of the input that would give the printed number, the other one being in the middle of its interval.
  [[nodiscard]] double needed(const std::string& column, auto RowInput::*varied) const {
    const data::Interval ends = *std::optional<data::Interval>(input_.*varied);
    const auto value_at = [&](double at) {
      RowInput input = input_.middle();
      input.*varied = data::Interval::only(at);
      return replay_row(nip_, method_, input).at_centre.at(column);
    };
    const double at_low = value_at(ends.lower), at_high = value_at(ends.upper);
    const data::Interval& printed = table_.cell(row_, column).number->rounding;
    return input_for(at_low < printed.lower ? printed.lower : printed.upper, ends, at_low, at_high);
  }

  [[nodiscard]] std::string other_elements(const std::string& column) const {
    constexpr int most_tried = 12;
    std::string met;
    for (int elements = 1; elements <= most_tried; ++elements) {
      const data::Interval range = replay_row(nip_, elements, input_).range(column);
      if (table_.cell(row_, column).number->rounding.meets(range)) met += fmt::format(" {}", elements);
    }
    return met.empty() ? "no other number of elements up to 12 meets it"
                       : "met by chance with elements a side:" + met;
  }

  /// The element whose shear is closest to the printed number, unless it is the element with the largest shear.
  [[nodiscard]] std::string other_shear(const std::string& column) const {
    if (column != "q_max") return "";
    const std::vector<double> shear =
        shear_of_side(nip_, method_, input_.length.middle(), input_.creep->middle());
    const double printed = table_.cell(row_, column).number->value;
    const auto nearest =
        std::ranges::min_element(shear, {}, [&](double here) { return std::fabs(here - printed); });
    if (*nearest == std::ranges::max(shear)) return "";
    return fmt::format("not the largest: element {} of {} has {:.6g}", nearest - shear.begin() + 1,
                       shear.size(), *nearest);
  }

  const data::Table& table_;
  std::size_t row_;
  const data::ElasticNip& nip_;
  fast::LineLoadMethod method_;
  RowInput input_;
  ReplayedRow replayed_;
};

bool is_met(const ReplayedCell& cell) {
  return cell.verdict == Verdict::match || cell.verdict == Verdict::misprint;
}

/// Marks cells as errors of the seed if another reading of the whole table explains them. This reading must match more
/// than half of the cells that did not match, and lose no match.
void explain(std::vector<ReplayedCell>& cells, const std::vector<ReplayedCell>& other_reading) {
  std::size_t missed = 0, gained = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (is_met(cells[i]) && !is_met(other_reading[i])) return;
    if (cells[i].verdict == Verdict::unexplained) ++missed;
    if (!is_met(cells[i]) && is_met(other_reading[i])) ++gained;
  }
  if (2 * gained <= missed) return;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (is_met(cells[i]) || !is_met(other_reading[i])) continue;
    cells[i].verdict = Verdict::seed_error;
    cells[i].note =
        "the creep is not the printed one, which is rounded away from zero throughout this table; " +
        cells[i].note;
  }
}

constexpr std::array<LineLoadTable, 8> replayed_tables{{
    {"thesis-III", data::Friction::full, 2},
    {"thesis-IV", data::Friction::full, 3},
    {"thesis-V", data::Friction::full, 5, 3},
    {"thesis-VI", data::Friction::full, 10},
    {"thesis-VII", data::Friction::none, 2},
    {"thesis-VIII", data::Friction::none, 5},
    {"thesis-IX", data::Friction::none, 8},
    {"thesis-X", data::Friction::none, 10},
}};

}  // namespace

std::span<const LineLoadTable> line_load_tables() { return replayed_tables; }

const LineLoadTable& line_load_table(const std::string& id) {
  if (const auto* known = item_with(replayed_tables, &LineLoadTable::id, id)) return *known;
  throw data::BadInput("table", id, "is known but has no replay; there is one for thesis-III to thesis-X");
}

std::vector<double> shear_of_side(const data::ElasticNip& nip, const fast::LineLoadMethod& method,
                                  double length, double creep) {
  const auto loads = fast::line_loads_for_length(nip, method, length, {data::Grip::Creep::given, creep});
  std::vector<double> shear;
  for (auto k = static_cast<std::size_t>(loads.leading_elements); k > 0; --k)
    shear.push_back(std::fabs(loads.loads[k - 1].shear) / loads.element_width());
  return shear;
}

data::ElasticNip nip_of_the_tables(const data::Table& table) {
  return {table.parameter("R").value, table.parameter("B").value, data::seed::sheet_of_the_tables};
}

Replay replay_line_loads(data::Table table, data::Friction friction, int elements_per_side) {
  const data::ElasticNip nip = nip_of_the_tables(table);
  const bool grips = friction == data::Friction::full;
  Replay replay{std::move(table),
                fmt::format("line loads {}, {} elements a side, E = {:.6g} psi, poisson = {:g}",
                            grips ? "with full friction (5.6)-(5.10)" : "without friction (5.11)-(5.16)",
                            elements_per_side, nip.material.young, nip.material.poisson),
                {}};
  const auto append = [&](Replay& rows, CreepReading reading) {
    append_rows(rows, [&](std::size_t row) {
      return RowReplay(rows.table, row, nip, friction, elements_per_side, reading);
    });
  };
  append(replay, CreepReading::rounded);
  if (grips) {
    Replay other{replay.table, replay.method, {}};
    append(other, CreepReading::away_from_zero);
    explain(replay.cells, other.cells);
  }
  return replay;
}

}  // namespace nipref::verify
