#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nipref/fast/number/accuracy.hpp>
#include <nipref/verify/audit/error_spread.hpp>
#include <nipref/verify/audit/error_tally.hpp>
#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/catalogue/ranges.hpp>
#include <nipref/verify/support/json.hpp>
#include <nipref/verify/support/on_progress.hpp>

namespace nipref::verify {

/// A function that computes a quantity's values at points, with a NaN for a point that it refuses. It is called from
/// several threads at once.
using Evaluator = std::function<void(std::span<const Point> points, std::span<double> values)>;

/// The evaluator of fast's values. A value is a NaN where fast refuses the point.
Evaluator fast_evaluator(const Quantity& quantity, fast::Accuracy accuracy);

/// The largest number of points of a block.
inline constexpr std::size_t points_of_block = 4096;

struct AuditOptions {
  /// The approximate number of points. From about 10000 for each position argument on, they include all hard cases. 0
  /// stands for `density` times the number in the quantity's entry, at least one.
  std::size_t points = 0;
  fast::Accuracy accuracy;  ///< the accuracy asked of fast
  OnProgress progress = {};
  double density = 1;                   ///< > 0, read if `points` is 0
  Ranges ranges = {};                   ///< empty: the whole domain
  std::vector<Point> more_points = {};  ///< additional points
  std::optional<double> promise = {};   ///< units in the last place of the scale; nothing: the quantity's own
  double absolute = 0;                  ///< an error that is allowed in any case, unit of the quantity
  std::string seed = {};                ///< any text; it determines the random points
  bool search = true;                   ///< use a tenth of each block's points to search around its worst few
  std::size_t block = points_of_block;  ///< largest number of points of a block

  /// The number of points for this quantity.
  [[nodiscard]] std::size_t points_of(const Quantity& quantity) const;
  [[nodiscard]] double promise_of(const Quantity& quantity) const {
    return promise.value_or(quantity.promise);
  }
};

/// The findings in some blocks of an audit, in bounded memory. The sum does not depend on the order of the blocks.
/// Errors are upper bounds: ref's own error is added to each.
struct AuditTally {
  std::uint64_t points = 0;  ///< points compared
  /// Points that are refused, or at which the reference has no value of 21 digits.
  std::uint64_t left_out = 0;
  double max_error_ulp = 0, max_relative_error = 0;  ///< the largest found
  /// The largest ratio of an error to the allowed one; the promise is kept if it is <= 1. -1 without points.
  double allowance_used = -1;
  std::uint64_t worst_block = 0;
  Point worst = {};        ///< the point with the largest allowance_used, in the first block that has it
  double worst_ulp = 0;    ///< the error there
  ErrorTally errors = {};  ///< before the local search, units in the last place of the scale

  /// Adds the findings of one block.
  void add(const AuditTally& found, std::uint64_t block);
  /// See stored.hpp.
  static void members(auto& self, const auto& each) {
    each("points", self.points, "left_out", self.left_out, "max_ulp", self.max_error_ulp, "max_relative",
         self.max_relative_error, "used", self.allowance_used, "worst", self.worst, "worst_ulp",
         self.worst_ulp, "errors", self.errors);
  }
};

/// The result of the audit of one quantity.
struct AuditResult : AuditTally {
  const Quantity* quantity;
  double promise;           ///< units in the last place of the scale
  ErrorSpread spread = {};  ///< over the arguments, before the local search

  [[nodiscard]] bool kept() const { return allowance_used <= 1; }
  /// The share of the sampled domain that a fault must fill for the points to hit it with a probability of 95 %: w with
  /// 1 - (1 - w)^points = 0.95. A narrower fault may be missed.
  [[nodiscard]] double fault_width() const {
    return -std::expm1(std::log(0.05) / static_cast<double>(points));
  }
};

/// The version of the sampling: with another one the same options give other points.
inline constexpr int sampler_version = 3;

/// The points of an audit before its local search.
std::vector<Point> audit_points(const Quantity& quantity, const AuditOptions& options);

/// Searches for the arguments at which the evaluator's error is largest: at hard cases, zeros and their neighbours,
/// round, dense and random points, and by a local search around the worst few of each block. The result does not
/// depend on the number of threads. All points are stored, for the distribution of the errors. At full accuracy the
/// allowed error is promise * ulp(scale), at a lower one the larger of this and rtol * scale. Points that the
/// reference refuses are left out; BadInput if it refuses all of them. Throws Interrupted
/// (support/internal/interrupt.hpp) if the process is interrupted.
AuditResult audit(const Quantity& quantity, const Evaluator& evaluator, const AuditOptions& options);

/// Audits fast in the same way. Where fast states the error of a value, it must cover the error found, too.
AuditResult audit(const Quantity& quantity, const AuditOptions& options);

/// Audits given values, without a search. There must be as many values as points, and at least one.
AuditResult audit_values(const Quantity& quantity, std::span<const Point> points,
                         std::span<const double> values, const AuditOptions& options);

/// " name=decimal (hexadecimal)" for each argument. The decimal number has six digits, the hexadecimal one is exact.
std::string point_text(const Quantity& quantity, const Point& point);
Json point_json(const Quantity& quantity, const Point& point);

Json audit_row_json(const AuditResult& result);
/// The "rows" of an audit.
Json audit_json(const std::vector<AuditResult>& results);

}  // namespace nipref::verify
