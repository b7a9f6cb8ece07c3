#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/bench/bench.hpp>

namespace nipref::verify {

/// Ways to the same values, timed together.
struct BenchPart {
  std::string name;
  std::function<std::vector<BenchRow>()> rows;
};

/// What is timed besides the quantities of the catalogue: the rows have the group's name as `quantity`.
struct BenchGroup {
  std::string_view name;
  std::vector<BenchPart> (*parts)(int rounds);
};

/// Whole elastic contacts found for a load, by the thesis's method as it stands (line loads, 500 residues of each kernel,
/// its own iteration of the length to 0.2 %) and by the converged solver, with errors of the contact length; the replay of
/// Tables III to X.
std::vector<BenchPart> elastic_bench(int rounds);
/// The displacement Un under a moving load at several tolerances and by the thesis's plain sums, with errors over the scale
/// of the catalogue's Un; rolling contacts found for a load likewise; the replay of Tables XI to XXVI.
std::vector<BenchPart> viscoelastic_bench(int rounds);
/// The compliance of one line by fast and by ref, the contour of a sliding contact, and the exact ellipse.
std::vector<BenchPart> half_space_bench(int rounds);

inline constexpr BenchGroup bench_group_table[] = {{"elastic-nip", elastic_bench},
                                                   {"viscoelastic-nip", viscoelastic_bench},
                                                   {"half-space", half_space_bench}};

/// The rows of a group's parts. The times are medians over so many rounds.
std::vector<BenchRow> bench_group(const BenchGroup& group, const BenchProgress& progress, int rounds = 15);

}  // namespace nipref::verify
