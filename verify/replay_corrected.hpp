#pragma once
#include "verify/replay.hpp"

namespace nipref::verify {

/// Fills `corrected` in every cell of a replay of thesis III-X: the continuous contact that carries the row's
/// stated load at the material constants of the replay, within 1e-9. With full friction that contact has a
/// creep of its own, whatever the thesis chose. Fills `discretisation` too, with the deviations of L, d0 and
/// p_max of the replay from the continuous contact that carries the replay's own load.
void correct(Replay& replay);

}  // namespace nipref::verify
