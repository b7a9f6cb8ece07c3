#pragma once
#include <nipref/verify/bench/bench.hpp>

namespace nipref::verify {

/// Whole contacts, frictionless, found for a load: the thesis's method as it stands (line loads, 500 residues
/// of each kernel, its own iteration of the length to 0.2 %) beside the converged contact at several
/// accuracies, and the replay of Tables III to X; errors are those of the contact length. `quantity` is
/// "elastic-nip" in all rows. The times are medians over so many rounds.
BenchReport bench_contacts(const BenchProgress& progress, int rounds);
BenchReport bench_contacts(const BenchProgress& progress);  ///< 15 rounds

}  // namespace nipref::verify
