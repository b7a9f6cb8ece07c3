#pragma once
#include <string_view>
#include <vector>

#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/cli/options.hpp>
#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {

/// What is timed besides quantities.
std::vector<std::string_view> bench_groups();

/// All that is timed without being named: the groups, and the quantities that are not costly.
Selection bench_everything();

/// Times what is selected, of quantities and bench_groups(). What is finished, if the process is interrupted.
BenchReport bench_all(const Selection& selected, Progress& progress,
                      const std::vector<OtherKernel>& others = {});

}  // namespace nipref::verify
