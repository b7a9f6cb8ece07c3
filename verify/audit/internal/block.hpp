#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include <nipref/verify/audit/internal/comparator.hpp>
#include <nipref/verify/audit/internal/error_tally.hpp>
#include <nipref/verify/audit/internal/plan.hpp>

namespace nipref::verify {

/// The points that the reference knows, with what is found at them.
struct Compared {
  std::vector<Point> points;
  std::vector<Finding> findings;
  std::size_t left_out = 0;
};

/// What was found in some blocks of an audit, in bounded memory. Adding up does not depend on the order.
struct AuditTally {
  std::uint64_t points = 0;    ///< compared
  std::uint64_t left_out = 0;  ///< of the ranges, where there is no such quantity
  double max_ulp = 0, max_relative = 0;
  double allowance_used = -1;  ///< the largest; of none -1
  std::uint64_t worst_block = 0;
  Point worst = {};        ///< where that was found, in the first block of those where it was
  double worst_ulp = 0;    ///< the error there
  ErrorTally errors = {};  ///< before the local search, units in the last place of the scale

  /// Of one block.
  void add(const AuditTally& found, std::uint64_t block);
  [[nodiscard]] Json json() const;
  /// Of what json() gave about a quantity of so many arguments. JsonMisfit for anything else.
  static AuditTally of(const Json& json, std::size_t arguments);
};

/// What was found about a quantity.
struct QuantityFindings {
  AuditTally tally = {};
  Compared compared = {};  ///< before the local search; empty where the points are not kept

  /// Adds what was found in a block.
  void add(const QuantityFindings& found, std::uint64_t block);
};

/// Looks at the points of one block, and around its worst few. Deterministic, whatever the number of threads.
/// `on_progress`, which may be empty, is called with the part of them that is done.
QuantityFindings audit_block(const Quantity& quantity, const Ranges& ranges, const Comparator& comparator,
                             const AuditPlan& plan, std::size_t block,
                             const std::function<void(double part)>& on_progress);

/// Of points that may have no finding, those that have; and a tally of them.
Compared compared_of(std::vector<Point> points, const std::vector<std::optional<Finding>>& findings);
AuditTally tally_of(const Compared& compared);

/// In words for people and machines, without what says where on the axes errors lie. BadInput, the reference's of the
/// first point, if it knows none of them.
AuditResult result_of(const Quantity& quantity, const AuditOptions& options, const AuditTally& tally,
                      const Point& first);

}  // namespace nipref::verify
