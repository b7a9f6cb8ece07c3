#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/grade/plugin.hpp>

namespace nipref::verify {

/// One line of the table of speed against error.
struct BenchRow {
  std::string quantity;
  std::string arguments;  ///< range in words
  std::string method;
  double nanoseconds;  ///< per value, median over interleaved rounds
  /// In units in the last place of the scale; at N decimal digits the unit is 10^-N of the scale. Empty where
  /// nothing independent was compared with, here and below.
  std::optional<double> max_error_ulp;
  std::optional<double> max_relative_error;  ///< over the points that were compared with ref
  /// Time over that of fast (double) or ref (digits) on the same arguments, full accuracy.
  std::optional<double> ratio;
  /// A quarter of the rounds took less than the first, and a quarter more than the third.
  double quartile_1 = 0, quartile_3 = 0;
  /// Of the ways to the same values in this run none is as quick and more right, or as right and quicker, errors
  /// taken relative to the value. Only where an error is known.
  bool pareto_optimal = false;
};

/// Sets pareto_optimal in all rows. Ways are compared if their quantity and arguments are the same.
void mark_pareto_optimal(std::vector<BenchRow>& rows);

/// One of the ratios that the project promises, as measured in this run.
struct BenchRatio {
  std::string what;
  double measured;
  double target;
  bool of_errors = false;  ///< else of times, which depend on the machine and on what else it does
  [[nodiscard]] bool met() const { return measured >= target; }
};

struct BenchReport {
  std::vector<BenchRow> rows;
  std::vector<BenchRatio> ratios;
};

/// Of the promised ratios those that can be formed from these rows: where one of the two ways is not as right as the
/// ratio asks, there is none.
std::vector<BenchRatio> promised_ratios(const std::vector<BenchRow>& rows);

/// True if the promised ratios are met: all if `strict`, otherwise those of errors.
bool all_met(const BenchReport& report, bool strict);

/// Adds rows and ratios of another report.
void append(BenchReport& report, const BenchReport& more);

// What is interrupted (support/internal/interrupt.hpp) gives what it has finished.

/// Receives what is being timed; may be empty.
using BenchProgress = std::function<void(const std::string&)>;

/// Somebody's kernel of a quantity, timed beside fast in a process of its own.
struct OtherKernel {
  std::string name;
  std::string quantity;
  PluginKernel* kernel;  ///< belongs to the caller
};

/// Double precision: fast at several rtol, scalar and batch, beside the catalogue's peers and those of the other
/// kernels that are of this quantity, each with its error against ref.
std::vector<BenchRow> bench_double(const Quantity& quantity, const BenchProgress& progress,
                                   const std::vector<OtherKernel>& others = {});

/// 30 to 200 digits: ref, the first call (which builds the nodes) apart from the steady cost, beside the
/// catalogue's peers. Only quantities with multiprecision peers have such rows.
std::vector<BenchRow> bench_digits(const Quantity& quantity, const BenchProgress& progress);

/// All rows of these quantities, and of the promised ratios those that can be formed from them.
BenchReport bench(const std::vector<const Quantity*>& quantities, const BenchProgress& progress,
                  const std::vector<OtherKernel>& others = {});

}  // namespace nipref::verify
