#pragma once
#include <cstddef>
#include <functional>

#include <nipref/fast/number/accuracy.hpp>
#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

struct AuditOptions {
  /// About so many points; all hard cases are among them from about 10000 for each position on. 0: `density`
  /// times as many as the quantity's entry says, but one at least.
  std::size_t points = 0;
  fast::Accuracy accuracy;  ///< the accuracy asked of fast
  /// Called now and then with the number of points done; may be empty.
  std::function<void(std::size_t done)> progress = {};
  double density = 1;  ///< > 0, read if `points` is 0

  /// The points that are asked for of this quantity.
  [[nodiscard]] std::size_t points_of(const Quantity& quantity) const;
};

/// Fewer points than this say little about a promise that they find kept.
inline constexpr std::size_t enough_points = 100;

/// What an audit found about one quantity. Errors are upper bounds: ref's own error is added to each.
struct AuditResult {
  const Quantity* quantity;
  std::size_t points;     ///< points compared
  double max_error_ulp;   ///< largest error in units in the last place of the scale
  double mean_error_ulp;  ///< mean over the points before the local search
  double allowance_used;  ///< largest error over what the accuracy allows at that point; the promise is kept
                          ///< if <= 1
  Point worst;            ///< where allowance_used was found

  [[nodiscard]] bool kept() const { return allowance_used <= 1; }
  [[nodiscard]] bool few_points() const { return points < enough_points; }
};

/// Looks for the arguments at which fast is worst: hard cases, zeros and their neighbours, dense and random
/// points, then a local search around the worst few. Deterministic, whatever the number of threads. At full
/// accuracy the allowance is promise * ulp(scale); at a lower one rtol * scale, but not less than that.
/// Throws Interrupted (support/internal/interrupt.hpp) if the process is.
AuditResult audit(const Quantity& quantity, const AuditOptions& options);

}  // namespace nipref::verify
