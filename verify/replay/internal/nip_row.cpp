#include <nipref/verify/replay/internal/nip_tables.hpp>
#include <nipref/verify/replay/internal/readings.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {

template <class Contact>
RowValues row_values(double sheet_thickness, const Contact& contact) {
  const auto value = [&](auto member) -> double {
    const auto number = std::invoke(member, contact);
    if constexpr (requires { number.value; })
      return number.value;
    else
      return number;
  };
  const double length = value(&Contact::contact_length), d0 = value(&Contact::indentation),
               d1 = value(&Contact::leading_displacement), d2 = value(&Contact::trailing_displacement);
  return {{"W", value(&Contact::load)},
          {"L1", value(&Contact::leading_length)},
          {"L2", value(&Contact::trailing_length)},
          {"L", length},
          {"d0", d0},
          {"d1", d1},
          {"d2", d2},
          {"L/B", length / sheet_thickness},
          {"d0/B", d0 / sheet_thickness},
          {"d1/B", d1 / sheet_thickness},
          {"d2/B", d2 / sheet_thickness},
          {"d1/d0", d1 / d0},
          {"d2/d0", d2 / d0},
          {"p_max", value(&Contact::peak_pressure)},
          {"q_max", value(&Contact::peak_shear)},
          {"creep", value(&Contact::creep_ratio)},
          {"muR", value(&Contact::rolling_resistance)}};
}
template RowValues row_values(double sheet_thickness, const fast::LineLoadNip& contact);
template RowValues row_values(double sheet_thickness, const fast::ConvergedNip& contact);

data::Interval ReplayedRow::range(const std::string& column) const {
  data::Interval all = data::Interval::only(at_centre.at(column));
  for (const RowValues& corner : corners) {
    all.lower = std::min(all.lower, corner.at(column));
    all.upper = std::max(all.upper, corner.at(column));
  }
  return all;
}

ReplayedRow replay_row(const std::vector<data::Interval>& inputs,
                       const std::function<RowValues(const std::vector<double>& inputs)>& solve) {
  std::vector<std::vector<double>> corners{{}};
  for (const data::Interval& input : inputs) {
    std::vector<std::vector<double>> longer;
    for (const std::vector<double>& corner : corners)
      for (const double end : {input.lower, input.upper}) {
        longer.push_back(corner);
        longer.back().push_back(end);
      }
    corners = std::move(longer);
  }
  return {solve(mapped(inputs, &data::Interval::middle)), mapped(corners, solve)};
}

ReplayedCell NipRow::cell(const std::string& column) const {
  const data::TableCell& text = printed(column);
  const data::Interval range = replayed_.range(column);
  ReplayedCell cell{row_, column, replayed_.at_centre.at(column), range, assess(text, range), ""};
  if (const auto input = inputs_.find(column); input != inputs_.end()) {
    cell.verdict = Verdict::input;
    cell.note = input->second;
  } else if (cell.verdict != Verdict::match) {
    const bool is_tried = cell.verdict == Verdict::unexplained && text.is_readable();
    cell.note = all_outcomes({text.erratum          ? text.erratum->reason
                              : !text.is_readable() ? "nothing legible"
                                                    : "",
                              is_tried ? attempts(cell) : ""});
  }
  if (cell.verdict == Verdict::unexplained) explain(cell);
  for (const data::Interval& length : other_lengths_)
    if (cell.verdict == Verdict::unexplained || cell.verdict == Verdict::misprint)
      judge_reading(table_, cell, with(elements_, length).range(column));
  return cell;
}

const ReplayedRow& NipRow::with(const Elements& elements, const data::Interval& length) const {
  const auto [known, is_new] = rows_.try_emplace({elements, length.lower, length.upper});
  if (is_new) known->second = replay(elements, length);
  return known->second;
}

std::vector<NipRow::Elements> NipRow::meeting(const ReplayedCell& missed,
                                              const std::vector<Elements>& candidates) const {
  std::vector<Elements> met;
  std::ranges::copy_if(candidates, std::back_inserter(met), [&](const Elements& elements) {
    const data::Interval range = with(elements, length_).range(missed.column);
    return printed(missed.column).number->rounding.meets(range);
  });
  return met;
}

void append_rows(Replay& replay, const std::function<std::unique_ptr<NipRow>(std::size_t row)>& replay_of) {
  struct Row {
    ReplayedNip nip;
    std::vector<ReplayedCell> cells;
  };
  const auto rows = parallel_mapped(replay.table.rows.size(), [&](std::size_t row) {
    const auto one = replay_of(row);
    Row replayed{one->nip(), {}};
    for (const data::TableColumn& column : replay.table.columns)
      if (!column.is_key) replayed.cells.push_back(one->cell(column.name));
    return replayed;
  });
  for (const Row& row : rows) {
    replay.nips.push_back(row.nip);
    std::ranges::copy(row.cells, std::back_inserter(replay.cells));
  }
}

}  // namespace nipref::verify
