#pragma once
#include "verify/replay.hpp"

namespace nipref::verify {

/// Replays a table of the frictionless elastic nip (thesis VII-X): each row from its printed contact length,
/// with `elements_per_side` line loads a side, at the material constants that reproduce the tables.
Replay replay_frictionless_line_loads(data::Table table, int elements_per_side);

}  // namespace nipref::verify
