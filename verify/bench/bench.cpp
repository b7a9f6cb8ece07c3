#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/bench/bench.hpp>

namespace nipref::verify {
namespace {

/// What is promised: the time of `slow` over the time of `quick` for the same quantity and arguments, both values
/// being right to `tolerance`, relative: it costs nothing to be quicker than what gives another value.
struct Promise {
  std::string_view what;
  std::string_view quantity;
  std::string_view arguments;
  std::string_view slow;
  std::string_view quick;
  double target;
  double tolerance;
  std::string_view instruction_set = {};  ///< that fast runs on; empty: any
};

constexpr std::string_view everyday_range = "alpha in [1e-6,20] log-uniform";
/// Where the rules of the peers in double converge; for larger arguments they are wrong by more than the value.
constexpr std::string_view converging_range = "alpha in [1e-3,1]";
constexpr std::string_view digits_arguments = "alpha in {0.01, 0.73, 5}";

constexpr Promise promises[] = {
    {"fast I1 against Boost's Ooura, both right to 1e-12, alpha in [1e-3,1]", "I1", converging_range,
     "Boost ooura_fourier_cos", "fast full", 60, 1e-12},
    {"fast I1 against GSL's QAWF, both right to 1e-12, alpha in [1e-3,1]", "I1", converging_range, "GSL QAWF",
     "fast full", 500, 1e-12},
    {"batch I1 against scalar", "I1", everyday_range, "fast full", "fast batch full", 3, 1e-12, "v4"},
    {"batch I1 against scalar", "I1", everyday_range, "fast full", "fast batch full", 2, 1e-12, "v3"},
    {"scalar I1, rtol=1e-6 against full", "I1", everyday_range, "fast full", "fast rtol=1e-06", 1.5, 1e-5},
    {"batch I1, rtol=1e-6 against full", "I1", everyday_range, "fast batch full", "fast batch rtol=1e-06",
     1.5, 1e-5},
    {"ref I1 at 50 digits against Boost's exp_sinh, both right to 1e-46", "I1", digits_arguments,
     "Boost exp_sinh 50 digits", "ref 50 digits", 100, 1e-46},
};

const BenchRow* find_row(const std::vector<BenchRow>& rows, const Promise& promise, std::string_view method) {
  const auto found = std::ranges::find_if(rows, [&](const BenchRow& row) {
    return row.quantity == promise.quantity && row.arguments == promise.arguments && row.method == method &&
           row.max_relative_error && *row.max_relative_error <= promise.tolerance;
  });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

std::vector<BenchRatio> promised_ratios(const std::vector<BenchRow>& rows) {
  std::vector<BenchRatio> formed;
  for (const Promise& promise : promises) {
    if (!promise.instruction_set.empty() && promise.instruction_set != fast::instruction_set()) continue;
    const BenchRow* slow = find_row(rows, promise, promise.slow);
    const BenchRow* quick = find_row(rows, promise, promise.quick);
    if (slow == nullptr || quick == nullptr) continue;
    formed.push_back({std::string(promise.what), slow->nanoseconds / quick->nanoseconds, promise.target});
  }
  return formed;
}

bool all_met(const BenchReport& report, bool strict) {
  return std::ranges::all_of(report.ratios, [strict](const BenchRatio& ratio) {
    return ratio.met() || !(strict || ratio.of_errors);
  });
}

void mark_pareto_optimal(std::vector<BenchRow>& rows) {
  const auto is_beaten = [](const BenchRow& row, const BenchRow& by) {
    if (by.quantity != row.quantity || by.arguments != row.arguments || !by.max_relative_error) return false;
    const double error = *by.max_relative_error, own = *row.max_relative_error;
    return by.nanoseconds <= row.nanoseconds && error <= own &&
           (by.nanoseconds < row.nanoseconds || error < own);
  };
  for (BenchRow& row : rows) {
    row.pareto_optimal = row.max_relative_error &&
                         std::ranges::none_of(rows, [&](const BenchRow& by) { return is_beaten(row, by); });
  }
}

void append(BenchReport& report, const BenchReport& more) {
  std::ranges::copy(more.rows, std::back_inserter(report.rows));
  std::ranges::copy(more.ratios, std::back_inserter(report.ratios));
}

BenchReport bench(const std::vector<const Quantity*>& quantities, const BenchProgress& progress,
                  const std::vector<OtherKernel>& others) {
  BenchReport report;
  for (const Quantity* quantity : quantities) {
    std::ranges::move(bench_double(*quantity, progress, others), std::back_inserter(report.rows));
    std::ranges::move(bench_digits(*quantity, progress), std::back_inserter(report.rows));
  }
  report.ratios = promised_ratios(report.rows);
  return report;
}

}  // namespace nipref::verify
