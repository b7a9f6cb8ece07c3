#pragma once
#include <string>
#include <vector>

#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// Table for people, one line a row; quantity and range are not repeated.
std::string bench_text(const std::vector<BenchRow>& rows);

/// The promised ratios with their verdicts.
std::string ratios_text(const std::vector<BenchRatio>& ratios);

/// What `bench` answers, and what stands for it in a report.
Json bench_json(const BenchReport& report);

}  // namespace nipref::verify
