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

/// The name, among a row's values, of the magnitude of an element's shear. Elements are counted from the middle.
std::string shear_of(int element) { return fmt::format("shear of element {}", element); }

/// A row of a table of the elastic nip: its inputs are the length and, with full friction, the creep.
class ElasticRow final : public NipRow {
 public:
  ElasticRow(const data::Table& table, std::size_t row, const data::ElasticNip& nip, data::Friction friction,
             int elements, CreepReading reading)
      : NipRow(table, row), nip_(nip) {
    if (friction == data::Friction::full) {
      if (!printed("creep").is_readable())
        throw data::BadInput("creep", printed("creep").printed, "must be readable");
      creep_ = creep_interval(*printed("creep").number, reading);
    }
    const data::TableCell &length = printed("L"), &ratio = printed("L/B");
    const bool length_is_printed = length.is_printed() && length.is_readable();
    if (!length_is_printed && !ratio.is_readable())
      throw data::BadInput("L", ratio.printed, "or L/B must be readable");
    const data::Interval from_ratio =
        ratio.is_readable() ? ratio.number->rounding.times(nip.sheet_thickness) : data::Interval{};
    begin({elements, elements}, length_is_printed ? length.number->rounding : from_ratio);
    // Misprints are judged for the part of the length's interval that agrees with L/B, if L/B is printed.
    other_lengths_ = {ratio.is_readable() && !ratio.is_doubtful() ? length_.within(from_ratio) : length_};
    if (creep_) inputs_["creep"] = "";
    if (!length_is_printed) inputs_["L/B"] = "";
    inputs_["L"] = (length_is_printed ? "" : "not legible, taken from L/B; ") +
                   load_note(replayed_.at_centre.at("W"), printed("W").number->value) +
                   agreement_on_length(table, row, [&](double at) {
                     return replay(elements_, data::Interval::only(at)).at_centre;
                   });
  }

 private:
  [[nodiscard]] RowValues solved(int elements, const std::vector<double>& inputs) const {
    const auto friction = creep_ ? data::LineLoadFriction::full(inputs.at(1)) : data::LineLoadFriction{};
    const auto loads = fast::line_loads_for_length(nip_, elements, inputs.front(), friction);
    RowValues values = row_values(nip_.sheet_thickness, loads);
    for (int element = 1; creep_ && element <= elements; ++element)
      values[shear_of(element)] =
          std::fabs(loads.loads[static_cast<std::size_t>(elements - element)].shear) / loads.element_width();
    return values;
  }

  [[nodiscard]] ReplayedRow replay(const Elements& elements, const data::Interval& length) const override {
    std::vector<data::Interval> inputs{length};
    if (creep_) inputs.push_back(*creep_);
    return replay_row(inputs, [&](const auto& at) { return solved(elements.leading, at); });
  }

  /// The printed shear may be that of the table's usual element although another element has the largest shear.
  void explain(ReplayedCell& missed) const override {
    const int element = line_load_table(table_.id).shear_element;
    if (missed.column != "q_max" || element == 0) return;
    const std::string shear = shear_of(element);
    if (assess(printed("q_max"), replayed_.range(shear)) == Verdict::unexplained) return;
    missed.verdict = Verdict::seed_error;
    missed.note = fmt::format(
        "not the largest shear: that of element {} of {}, {:.6g}, which is the largest in most rows of the table",
        element, elements_.leading, replayed_.at_centre.at(shear));
  }

  /// Tries another digit, length, creep ratio or number of elements, and the shear of another element.
  [[nodiscard]] std::string attempts(const ReplayedCell& missed) const override {
    return all_outcomes({other_shear(missed), one_digit(table_, row_, missed.column, missed.range),
                         fmt::format("it would take L = {:.6g}e-3", 1e3 * needed(missed.column, 0)),
                         creep_ ? fmt::format("or creep = {:.7g}e-4", 1e4 * needed(missed.column, 1)) : "",
                         other_elements(missed)});
  }

  /// The value of this input that would give the printed number while the other input is the middle of its interval.
  [[nodiscard]] double needed(const std::string& column, std::size_t input) const {
    const data::Interval ends = input == 0 ? length_ : creep_.value();
    const auto value_at = [&](double at) {
      std::vector<double> inputs{length_.middle(), creep_.value_or(data::Interval{}).middle()};
      inputs[input] = at;
      return solved(elements_.leading, inputs).at(column);
    };
    const double at_low = value_at(ends.lower), at_high = value_at(ends.upper);
    const data::Interval& goal = printed(column).number->rounding;
    return input_for(at_low < goal.lower ? goal.lower : goal.upper, ends, at_low, at_high);
  }

  [[nodiscard]] std::string other_elements(const ReplayedCell& missed) const {
    std::vector<Elements> tried;
    for (int elements = 1; elements <= 12; ++elements) tried.push_back({elements, elements});
    std::string met;
    for (const Elements& elements : meeting(missed, tried)) met += fmt::format(" {}", elements.leading);
    return met.empty() ? "no other number of elements up to 12 meets it"
                       : "met by chance with elements a side:" + met;
  }

  /// The element whose shear is closest to the printed number, unless it is the element with the largest shear.
  [[nodiscard]] std::string other_shear(const ReplayedCell& missed) const {
    if (missed.column != "q_max") return "";
    const auto shear = [&](int element) { return replayed_.at_centre.at(shear_of(element)); };
    const auto elements = std::views::iota(1, elements_.leading + 1);
    const double goal = printed("q_max").number->value;
    const int nearest =
        *std::ranges::min_element(elements, {}, [&](int one) { return std::fabs(shear(one) - goal); });
    if (shear(nearest) == std::ranges::max(elements | std::views::transform(shear))) return "";
    return fmt::format("not the largest: element {} of {} has {:.6g}", nearest, elements_.leading,
                       shear(nearest));
  }

  const data::ElasticNip& nip_;
  std::optional<data::Interval> creep_;  ///< with full friction
};

bool is_met(const ReplayedCell& cell) {
  return cell.verdict == Verdict::match || cell.verdict == Verdict::misprint;
}

/// Marks cells as errors of the seed if another reading of the whole table explains them. The other reading must match
/// more than half of the cells that did not match, and must lose no match.
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

data::ElasticNip nip_of_the_tables(const data::Table& table) {
  return {table.parameter("R").value, table.parameter("B").value, data::seed::sheet_of_the_tables};
}

Replay replay_line_loads(data::Table table, data::Friction friction, int elements_per_side) {
  const data::ElasticNip nip = nip_of_the_tables(table);
  const bool sticks = friction == data::Friction::full;
  Replay replay{std::move(table),
                fmt::format("line loads {}, {} elements a side, E = {:.6g} psi, poisson = {:g}",
                            sticks ? "with full friction (5.6)-(5.10)" : "without friction (5.11)-(5.16)",
                            elements_per_side, nip.material.young, nip.material.poisson),
                {}};
  const auto append = [&](Replay& rows, CreepReading reading) {
    append_rows(rows, [&](std::size_t row) {
      return std::make_unique<ElasticRow>(rows.table, row, nip, friction, elements_per_side, reading);
    });
  };
  append(replay, CreepReading::rounded);
  if (sticks) {
    Replay other{replay.table, replay.method, {}};
    append(other, CreepReading::away_from_zero);
    explain(replay.cells, other.cells);
  }
  return replay;
}

}  // namespace nipref::verify
