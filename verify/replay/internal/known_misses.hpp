#pragma once
#include <vector>

#include <nipref/data/table/known_misses.hpp>
#include <nipref/verify/replay/replay.hpp>

namespace nipref::verify {

/// Whether a cell is one of those known. A replay that misses any other has lost something.
bool is_known_miss(const std::vector<data::KnownMiss>& known, const Replay& replay, const ReplayedCell& cell);

}  // namespace nipref::verify
