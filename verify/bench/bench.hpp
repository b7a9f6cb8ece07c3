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
  std::string arguments;  ///< range in words
  std::string method;
  double nanoseconds;  ///< for one value, median over interleaved rounds
  /// In units in the last place of the scale; at N decimal digits the unit is 10^-N of the scale. Both errors are empty
  /// where nothing independent was compared.
  std::optional<double> max_error_ulp;
  std::optional<double> max_relative_error;
  /// The time over that of fast (double) or ref (digits) for the same arguments, at full accuracy.
  std::optional<double> ratio;
  double quartile_1 = 0, quartile_3 = 0;  ///< of the rounds' times
  /// Of the errors in ulp; empty also where only a few points were compared.
  std::optional<double> mean_error_ulp = {}, percentile_99_9_ulp = {};
  /// No other way to the same values in this run is both as quick and as right, and better in one of the two. Errors are
  /// relative to the value; false where the error is not known.
  bool pareto_optimal = false;
};

/// Sets pareto_optimal in all rows. Ways are compared if their quantity and arguments are the same.
void mark_pareto_optimal(std::vector<BenchRow>& rows);

/// One of the ratios that the project promises, as measured in this run.
struct BenchRatio {
  std::string what;
  double measured;
  double target;
  bool of_errors = false;  ///< else of times, which depend on the machine and its load
  [[nodiscard]] bool met() const { return measured >= target; }
};

struct BenchReport {
  std::vector<BenchRow> rows;
  std::vector<BenchRatio> ratios;
};

/// The ratios promised in data/statements/speed.toml that can be formed from these rows: a ratio of times is left out where
/// one of the two ways is less accurate than the promise demands.
std::vector<BenchRatio> promised_ratios(const std::vector<BenchRow>& rows);

/// True if the promised ratios are met: all if `strict`, otherwise those of errors.
bool all_met(const BenchReport& report, bool strict);

/// Ways to the same values, timed together.
struct BenchPart {
  std::string name;
  std::function<std::vector<BenchRow>()> rows;
};

/// A user's kernel of a quantity, timed beside fast in a process of its own.
struct OtherKernel {
  std::string name;
  PluginKernel* kernel;  ///< belongs to the caller
};

/// Double precision: fast at several rtol, scalar and batch, the catalogue's peers, and those of the other kernels that
/// compute this quantity, each with its error against ref. A part for each range; the parts refer to the quantity.
std::vector<BenchPart> double_bench(const Quantity& quantity, const std::vector<OtherKernel>& others = {});

/// 30 to 200 digits: ref and the catalogue's multiprecision peers, and ref's first call, which builds the quadrature nodes.
/// Empty for a quantity without such peers.
std::vector<BenchPart> digits_bench(const Quantity& quantity);

/// The rows that follow each other and are ways to the same values.
std::vector<std::span<const BenchRow>> ways_to_same_values(const std::vector<BenchRow>& rows);

/// {"what", "ratio", "wanted", "met"}
Json ratio_json(const BenchRatio& ratio);

/// What `bench` answers, and what stands for it in a report.
Json bench_json(const BenchReport& report);

}  // namespace nipref::verify
