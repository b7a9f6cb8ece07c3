#pragma once
#include <initializer_list>
#include <vector>

#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/replay/row.hpp>

namespace nipref::verify {

/// Fills `corrected` in every cell of a replay: the continuous contact that carries the row's stated load.
/// For thesis III-X at the material constants of the replay, within 1e-9; with full friction that contact has
/// a creep of its own, whatever the thesis chose. For thesis XI-XXVI see internal/viscoelastic_corrected.hpp.
/// Fills `costs` too: of thesis III-X the deviations of L, d0 and p_max of the replay from the continuous
/// contact that carries the replay's own load.
void correct(Replay& replay);

/// Deviations of some columns of rows from the true ones.
std::vector<ColumnDeviation> deviations(std::initializer_list<const char*> columns,
                                        const std::vector<RowValues>& rows,
                                        const std::vector<RowValues>& truth);

}  // namespace nipref::verify
