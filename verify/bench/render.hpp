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

/// {"rows": [{quantity, arguments, method, ns, max_error_ulp, max_relative_error}], "ratios": [{what,
/// measured, target}]}; null is what was not compared, or is infinite.
Json bench_json(const BenchReport& report);

}  // namespace nipref::verify
