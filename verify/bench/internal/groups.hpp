#pragma once
#include <nipref/verify/bench/bench.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {

inline constexpr int usual_rounds = 15;

/// A group of timings besides the quantities of the catalogue. Its rows have its name as `quantity`.
struct BenchGroup {
  std::string_view name;
  std::vector<BenchPart> (*parts)();
};

/// Whole elastic contacts for a given load, with errors of the contact length: by the thesis's method (line loads, 500
/// residues of each kernel, its iteration of the length to 0.2 %) and by the converged solver. With Coulomb's friction:
/// by line loads and the converged solver, with errors of the creep ratio. Also the replay of Tables III to X.
std::vector<BenchPart> elastic_bench();
/// The displacement Un under a moving load at several tolerances and by the thesis's plain sums, with errors relative
/// to the scale of the catalogue's Un; rolling contacts for a given load; the replay of Tables XI to XXVI.
std::vector<BenchPart> viscoelastic_bench();
/// The compliance of one line by fast and by ref, the contour of a sliding contact, and the exact ellipse.
std::vector<BenchPart> half_space_bench();

inline constexpr BenchGroup bench_group_table[] = {{"elastic-nip", elastic_bench},
                                                   {"viscoelastic-nip", viscoelastic_bench},
                                                   {"half-space", half_space_bench}};

/// The largest errors of a way to compute some values, and the distribution of its errors in ulp.
struct WayError {
  std::optional<double> ulps, relative, mean_ulps = {}, percentile_999_ulps = {};
};
inline WayError of_relative(double error) { return {error / 0x1p-52, error}; }

/// One of several ways to compute the same values.
struct TimedWay {
  std::string name;
  Contender contender;
  std::function<WayError()> error = {};  ///< computed after the timing; empty without an independent value
};

struct TimedRounds {
  std::size_t over = 0;  ///< the way to whose time the ratios refer
  int count = usual_rounds;
  double seconds = 5e-3;            ///< of one round
  double values_in_evaluation = 1;  ///< number of values that one timed evaluation computes
};

/// Times the ways in turn and returns a row for each.
std::vector<BenchRow> timed_rows(const std::string& quantity, const std::string& arguments,
                                 const std::vector<TimedWay>& ways, const TimedRounds& rounds = {});

/// A contender that calls work(i) for i from 0 to count - 1.
template <class Work>
Contender repeated(Work work, std::size_t most = 1000) {
  return {[work](std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) static_cast<void>(work(i));
          },
          1, most};
}

}  // namespace nipref::verify
