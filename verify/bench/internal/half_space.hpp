#pragma once
#include <nipref/verify/bench/bench.hpp>

namespace nipref::verify {

/// Bodies on half-spaces, `quantity` "half-space" in all rows: the response of one line by fast and by the
/// reference, a sliding contact's contour in 1000 directions with its force, and the exact ellipse.
BenchReport bench_half_space(const BenchProgress& progress);

}  // namespace nipref::verify
