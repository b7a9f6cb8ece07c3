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

}  // namespace nipref::verify
