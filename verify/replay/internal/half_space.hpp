#pragma once
#include <span>
#include <string_view>

#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

/// Tables of the two papers on half-spaces: brock2012-1, -2, brock2013-1, -2, -3.
std::span<const std::string_view> half_space_tables();

bool is_half_space_table(std::string_view id);

/// Replays such a table by the formulas that made it; `corrected` is what the right formulas give in the
/// papers' own contour rule. The rule of verdicts: half_space_cell.hpp. `costs`: the replay against
/// the corrected values.
Replay replay_half_space(data::Table table);

}  // namespace nipref::verify
