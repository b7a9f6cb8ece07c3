#include <nipref/data/table/index.hpp>
#include <nipref/verify/replay/internal/half_space.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {
std::string_view name(Verdict verdict) { return verdict_names[static_cast<std::size_t>(verdict)]; }

std::size_t Replay::count(Verdict verdict) const {
  return static_cast<std::size_t>(std::ranges::count(cells, verdict, &ReplayedCell::verdict));
}

double key_of_row(const data::Table& table, std::size_t row) {
  return table.cell(row, table.columns.front().name).number->value;
}

Verdict assess(const data::TableCell& cell, const data::Interval& range) {
  if (!cell.is_readable()) return Verdict::unexplained;
  if (!cell.number->rounding.meets(range)) return Verdict::unexplained;
  return cell.read_as == cell.printed || cell.has_lost_digit() ? Verdict::match : Verdict::misprint;
}

std::vector<std::string> replayable_tables() {
  std::vector<std::string> ids;
  for (const LineLoadTable& table : line_load_tables()) ids.emplace_back(table.id);
  for (const ViscoelasticTable& table : viscoelastic_tables()) ids.emplace_back(table.id);
  for (const HalfSpaceTable& table : half_space_tables()) ids.emplace_back(table.id);
  return ids;
}

Replay replay_table(const std::string& id) {
  data::Table table = data::load_table_by_id(id);
  if (const HalfSpaceTable* of_papers = item_with(half_space_tables(), &HalfSpaceTable::id, id))
    return replay_half_space(std::move(table), *of_papers);
  if (const ViscoelasticTable* rolling = find_viscoelastic_table(id))
    return replay_viscoelastic(std::move(table), *rolling);
  const LineLoadTable& how = line_load_table(id);
  return replay_line_loads(std::move(table), how.friction, how.elements_per_side);
}

bool is_known_miss(const std::vector<data::KnownMiss>& known, const Replay& replay,
                   const ReplayedCell& cell) {
  return std::ranges::any_of(known, [&](const data::KnownMiss& miss) {
    return miss.table == replay.table.id && miss.row == cell.row + 1 && miss.column == cell.column;
  });
}

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
  data::Interval all{at_centre.at(column), at_centre.at(column)};
  for (const RowValues& corner : corners) {
    all.lower = std::min(all.lower, corner.at(column));
    all.upper = std::max(all.upper, corner.at(column));
  }
  return all;
}

RowInput RowInput::middle() const {
  const auto middle_of = [](const data::Interval& all) { return data::Interval::only(all.middle()); };
  return {middle_of(length), creep ? std::optional(middle_of(*creep)) : std::nullopt};
}

std::vector<RowInput> RowInput::corners() const {
  std::vector<RowInput> all;
  for (const double L : {length.lower, length.upper}) {
    if (!creep) all.push_back({data::Interval::only(L), {}});
    for (const double one : creep ? std::vector{creep->lower, creep->upper} : std::vector<double>())
      all.push_back({data::Interval::only(L), data::Interval::only(one)});
  }
  return all;
}

ReplayedRow replay_row(const data::ElasticNip& nip, const fast::LineLoadMethod& method,
                       const RowInput& input) {
  const auto solved = [&](const RowInput& at) {
    using data::Grip;
    const Grip grip = at.creep ? Grip{Grip::Creep::given, at.creep->lower} : Grip{};
    return row_values(nip.sheet_thickness, fast::line_loads_for_length(nip, method, at.length.lower, grip));
  };
  return {solved(input.middle()), mapped(input.corners(), solved)};
}

}  // namespace nipref::verify
