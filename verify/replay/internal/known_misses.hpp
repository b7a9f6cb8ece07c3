#pragma once
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

/// Whether a cell is one of those that no replay meets though nothing in its table speaks against them:
/// known, looked into (see the notes of the replay), and left. A replay that misses any other has lost
/// something.
bool is_known_miss(const Replay& replay, const ReplayedCell& cell);

}  // namespace nipref::verify
