#pragma once
#include <nipref/verify/bench/bench.hpp>

namespace nipref::verify {

/// The viscoelastic sheet, `quantity` "viscoelastic-nip" in all rows: Un at several tolerances beside the
/// thesis's plain sums (errors over the scale of the catalogue's Un), whole nips found for a load by the thesis's
/// method and converged (errors of the contact length), and all rows of Tables XI to XXVI replayed with 500
/// terms and with exact kernels.
BenchReport bench_viscoelastic(const BenchProgress& progress);

}  // namespace nipref::verify
