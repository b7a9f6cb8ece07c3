#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/grade/plugin.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// One line of the table of speed against error.
struct BenchRow {
  std::string quantity;
  std::string arguments;  ///< the range in words
  std::string method;
  double nanoseconds;  ///< time of one value, median over interleaved rounds
  /// The largest error in units in the last place of the scale; for N decimal digits the unit is 10^-N of the scale.
  /// Both errors are empty if there is no independent value to compare with.
  std::optional<double> max_error_ulp;
  std::optional<double> max_relative_error;
  /// The time divided by that of fast (double) or ref (digits) for the same arguments at full accuracy.
  std::optional<double> ratio;
  double quartile_1 = 0, quartile_3 = 0;  ///< quartiles of the rounds' times
  /// Statistics of the errors in ulp; also empty if only a few points were compared.
  std::optional<double> mean_error_ulp = {}, percentile_99_9_ulp = {};
  /// True if no other way to the same values in this run is at least as fast and at least as accurate, and better in
  /// one of the two. Accuracy is the error relative to the value; false if this error is unknown.
  bool pareto_optimal = false;
};

/// Sets pareto_optimal in all rows. Ways are compared if their quantity and arguments are the same.
void mark_pareto_optimal(std::vector<BenchRow>& rows);

/// One of the ratios that the project promises, as measured in this run.
struct BenchRatio {
  std::string what;
  double measured;
  double target;
  bool of_errors = false;  ///< of errors; otherwise of times, which depend on the machine and its load
  [[nodiscard]] bool met() const { return measured >= target; }
};

struct BenchReport {
  std::vector<BenchRow> rows;
  std::vector<BenchRatio> ratios;
};

/// The ratios promised in data/statements/speed.toml that these rows admit. A ratio of times is left out if one of the
/// two ways is less accurate than the promise demands.
std::vector<BenchRatio> promised_ratios(const std::vector<BenchRow>& rows);

/// True if the promised ratios are met: all if `strict`, otherwise those of errors.
bool all_met(const BenchReport& report, bool strict);

/// Ways to the same values. They are timed together.
struct BenchPart {
  std::string name;
  std::function<std::vector<BenchRow>()> rows;
};

/// A user's kernel of a quantity. It is timed beside fast, in its own process.
struct OtherKernel {
  std::string name;
  PluginKernel* kernel;  ///< belongs to the caller
};

/// The ways in double precision: fast at several rtol, scalar and batch, the catalogue's peers, and the other kernels
/// of this quantity, each with its error against ref. One part for each range; the parts refer to the quantity.
std::vector<BenchPart> double_bench(const Quantity& quantity, const std::vector<OtherKernel>& others = {});

/// The ways with 30 to 200 digits: ref, the catalogue's multiprecision peers, and the first call of ref, which computes
/// the quadrature nodes. Empty for a quantity without such peers.
std::vector<BenchPart> digits_bench(const Quantity& quantity);

/// Groups consecutive rows that are ways to the same values.
std::vector<std::span<const BenchRow>> ways_to_same_values(const std::vector<BenchRow>& rows);

/// {"what", "ratio", "wanted", "met"}
Json ratio_json(const BenchRatio& ratio);

/// The answer of `bench`, also a part of a report.
Json bench_json(const BenchReport& report);

}  // namespace nipref::verify
