#pragma once
#include <initializer_list>
#include <vector>

#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

/// Sets `corrected` in every cell of a replay to the result of the continuous contact under the row's stated load.
/// For thesis III-X it has the replay's material constants and is accurate to 1e-9; with full friction it has its own
/// creep ratio, which need not be the one that the thesis chose. For thesis XI-XXVI see
/// internal/viscoelastic_nip.hpp. Sets `costs` as well: for thesis III-X the deviations of the replay's L, d0 and
/// p_max from the continuous contact under the replay's own load.
void correct(Replay& replay);

/// The deviations of these columns from the columns of the true rows.
std::vector<ColumnDeviation> deviations(std::initializer_list<const char*> columns,
                                        const std::vector<RowValues>& rows,
                                        const std::vector<RowValues>& truth);

}  // namespace nipref::verify
