#pragma once
#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/report/report.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/internal/progress.hpp>
#include <nipref/verify/support/json.hpp>

// Functions that the verbs bench, tables and report share.

namespace nipref::verify {

/// The names of the groups that are timed besides quantities.
std::vector<std::string_view> bench_groups();

/// All that is timed without being named: the groups, and the quantities that are not costly.
Selection bench_everything();

/// Times the selected quantities and groups. If the process is interrupted, the report has what is finished.
BenchReport bench_all(const Selection& selected, Progress& progress,
                      const std::vector<OtherKernel>& others = {});

/// The tables of these ids, replayed and corrected; those that are finished, if the process is interrupted.
/// BadInput for unknown ids.
std::vector<Replay> replay_and_correct(const std::vector<std::string>& ids, Progress& progress);

/// Whether a cell is unexplained that is not contradicted by its own table and not listed in known_misses.csv.
bool fall_short(const std::vector<Replay>& replays);

}  // namespace nipref::verify
