#include "verify/replay.hpp"

#include <algorithm>

#include "data/bad_input.hpp"
#include "data/table_index.hpp"
#include "verify/replay_line_loads.hpp"

namespace nipref::verify {

std::string_view name(Verdict verdict) { return verdict_names[static_cast<std::size_t>(verdict)]; }

std::size_t Replay::count(Verdict verdict) const {
  return static_cast<std::size_t>(std::ranges::count(cells, verdict, &ReplayedCell::verdict));
}

Verdict judge(const data::TableCell& cell, const data::Interval& range) {
  if (!cell.is_readable()) return Verdict::unexplained;
  const data::Interval& printed = cell.number->rounding;
  const bool meets = printed.lower <= range.upper && range.lower <= printed.upper;
  if (!meets) return Verdict::unexplained;
  return cell.read_as == cell.printed ? Verdict::match : Verdict::misprint;
}

bool length_is_contradicted(const data::Table& table, std::size_t row) {
  const data::TableCell& length = table.cell(row, "L");
  const data::TableCell& ratio = table.cell(row, "L/B");
  if (!length.is_readable() || !ratio.is_readable()) return false;
  const double thickness = table.parameter("B").value;
  const double lower = std::max(length.number->rounding.lower, ratio.number->rounding.lower * thickness);
  const double upper = std::min(length.number->rounding.upper, ratio.number->rounding.upper * thickness);
  return upper - lower <= 1e-12 * length.number->value;  // rounding of the two ends
}

std::vector<std::string> replayable_tables() { return {"thesis-VII"}; }

Replay replay_table(const std::string& id) {
  data::Table table = data::load_table_by_id(id);
  if (!std::ranges::count(replayable_tables(), id)) {
    throw data::BadInput("table", id, "is known but has no replay; there is one for thesis-VII");
  }
  return replay_frictionless_line_loads(std::move(table), 2);
}

}  // namespace nipref::verify
