#pragma once
#include <cstdint>
#include <vector>

#include <nipref/verify/audit/internal/comparator.hpp>
#include <nipref/verify/audit/internal/error_tally.hpp>
#include <nipref/verify/audit/internal/plan.hpp>
#include <nipref/verify/support/on_progress.hpp>

namespace nipref::verify {

/// The points for which the reference has a value, with the findings at them.
struct Compared {
  std::vector<Point> points;
  std::vector<Finding> findings;
  std::size_t left_out = 0;
};

/// The findings in some blocks of an audit, in bounded memory. The sum does not depend on the order of the blocks.
struct AuditTally {
  std::uint64_t points = 0;    ///< points compared
  std::uint64_t left_out = 0;  ///< points of the ranges at which the quantity is not defined
  double max_ulp = 0, max_relative = 0;
  double allowance_used = -1;  ///< the largest; -1 without points
  std::uint64_t worst_block = 0;
  Point worst = {};        ///< the point with the largest allowance_used, in the first block that has it
  double worst_ulp = 0;    ///< the error there
  ErrorTally errors = {};  ///< before the local search, units in the last place of the scale

  /// Adds the findings of one block.
  void add(const AuditTally& found, std::uint64_t block);
  [[nodiscard]] Json json() const;
  /// Reads what json() has written for a quantity of so many arguments. JsonMisfit for anything else.
  static AuditTally of(const Json& json, std::size_t arguments);
};

/// The findings about a quantity.
struct QuantityFindings {
  AuditTally tally = {};
  Compared compared = {};  ///< the points before the local search; empty if they are not stored

  /// Adds the findings of a block.
  void add(const QuantityFindings& found, std::uint64_t block);
};

/// Compares the points of one block, and searches around its worst few. The result does not depend on the number of
/// threads.
QuantityFindings audit_block(const Quantity& quantity, const Ranges& ranges, const Comparator& comparator,
                             const AuditPlan& plan, std::size_t block, const OnProgress& on_progress);

/// The points that have a finding, and their tally.
Compared compared_of(std::vector<Point> points, const std::vector<std::optional<Finding>>& findings);
AuditTally tally_of(const Compared& compared);

/// The result of an audit without the distribution over the arguments. If the reference knows none of the points, its
/// BadInput for the first of them.
AuditResult result_of(const Quantity& quantity, const AuditOptions& options, const AuditTally& tally,
                      const Point& first);

}  // namespace nipref::verify
