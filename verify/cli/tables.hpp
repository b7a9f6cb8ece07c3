#pragma once
#include <string>
#include <vector>

#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {

/// The tables of these ids, replayed and corrected; those that are finished, if the process is interrupted.
/// BadInput for unknown ids.
std::vector<Replay> replay_and_correct(const std::vector<std::string>& ids, Progress& progress);

/// True if a cell is unexplained that neither its own row contradicts nor known_misses.csv lists.
bool fall_short(const std::vector<Replay>& replays);

}  // namespace nipref::verify
