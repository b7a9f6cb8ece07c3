#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nipref/fast/number/accuracy.hpp>
#include <nipref/verify/audit/error_spread.hpp>
#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/catalogue/ranges.hpp>

namespace nipref::verify {

/// Somebody's way to compute a quantity: values at points, one for each; a NaN where it refuses a point. Called from
/// several threads at once.
using Evaluator = std::function<void(std::span<const Point> points, std::span<double> values)>;

/// fast, with a NaN where it refuses a point.
Evaluator fast_evaluator(const Quantity& quantity, fast::Accuracy accuracy);

/// The points of an audit come in blocks of so many at most, each drawn and searched by itself.
inline constexpr std::size_t points_of_block = 4096;

struct AuditOptions {
  /// About so many points; all hard cases are among them from about 10000 for each position on. 0: `density`
  /// times as many as the quantity's entry says, but one at least.
  std::size_t points = 0;
  fast::Accuracy accuracy;  ///< the accuracy asked of fast
  /// Called now and then with the part of the points that is done; may be empty.
  std::function<void(double part)> progress = {};
  double density = 1;  ///< > 0, read if `points` is 0
  Ranges ranges = {};  ///< empty: the whole domain
  /// Looked at besides.
  std::vector<Point> more_points = {};
  std::optional<double> promise = {};  ///< units in the last place of the scale; none: the quantity's own
  std::string seed = {};               ///< any text: another one, other random points
  bool search = true;  ///< a tenth of the points of each block is for a local search around its worst few
  std::size_t block = points_of_block;  ///< most points of a block

  /// The points that are asked for of this quantity.
  [[nodiscard]] std::size_t points_of(const Quantity& quantity) const;
  [[nodiscard]] double promise_of(const Quantity& quantity) const {
    return promise.value_or(quantity.promise);
  }
};

/// Fewer points than this say little about a promise that they find kept.
inline constexpr std::size_t enough_points = 100;

/// What an audit found about one quantity. Errors are upper bounds: ref's own error is added to each.
struct AuditResult {
  const Quantity* quantity;
  std::size_t points;         ///< points compared
  std::size_t left_out;       ///< points of the ranges where there is no such quantity
  double promise;             ///< units in the last place of the scale
  double max_error_ulp;       ///< largest error found, in those units
  double max_relative_error;  ///< largest |error| / |value| found
  double allowance_used;  ///< largest error over what the accuracy allows at that point; the promise is kept
                          ///< if <= 1
  Point worst;            ///< where allowance_used was found
  ErrorSpread spread;     ///< over the points before the local search
  double worst_ulp = 0;   ///< the error there, units in the last place of the scale

  [[nodiscard]] bool kept() const { return allowance_used <= 1; }
  [[nodiscard]] bool few_points() const { return points < enough_points; }
};

/// Another number, other points for the same options.
inline constexpr int sampler_version = 3;

/// The points that an audit looks at before its local search.
std::vector<Point> audit_points(const Quantity& quantity, const AuditOptions& options);

/// Looks for the arguments at which the evaluator is worst: hard cases, zeros and their neighbours, round, dense and random
/// points, and in each block of them a local search around its worst few. Deterministic, whatever the number of threads.
/// Memory: all points, for the spread. (The command line's audits, which do not tell that, keep a block.) At full
/// accuracy the allowance is promise * ulp(scale); at a lower one rtol * scale, but not less than that. Points of
/// ranges that the reference refuses are left out; BadInput if it refuses all of them.
/// Throws Interrupted (support/internal/interrupt.hpp) if the process is.
AuditResult audit(const Quantity& quantity, const Evaluator& evaluator, const AuditOptions& options);

/// The same of fast, whose own statement of a value's error, where it makes one, must cover it besides.
AuditResult audit(const Quantity& quantity, const AuditOptions& options);

/// The same of values that are there already: no others are looked for. Points and values of equal number, one at
/// least.
AuditResult audit_values(const Quantity& quantity, std::span<const Point> points,
                         std::span<const double> values, const AuditOptions& options);

}  // namespace nipref::verify
