#pragma once
#include <cstdint>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/on_progress.hpp>

namespace nipref::verify {

/// The division of items into blocks, whose sizes differ by at most one.
struct Blocks {
  std::size_t items, count;

  /// Blocks of at most `most` items; at least one block.
  Blocks(std::size_t all, std::size_t most) : items(all), count(all == 0 ? 1 : (all - 1) / most + 1) {}
  [[nodiscard]] std::size_t size(std::size_t block) const {
    return items / count + (block < items % count ? 1 : 0);
  }
  /// The number of its first item.
  [[nodiscard]] std::size_t first(std::size_t block) const {
    return block * (items / count) + std::min(block, items % count);
  }
};

/// The points of an audit, in independent blocks: each block draws its points from its own seed, "seed/I1/block/17",
/// so that they are the same whichever process computes the others. The listed points (hard cases, zeros, round
/// arguments, the caller's own points) are made once, from the seed "seed/I1/listed", and dealt to the blocks. Memory
/// is needed for this list, whose size does not depend on the number of points, and for one block.
class AuditPlan {
 public:
  /// `quantity` and what `options` refer to must outlive it.
  AuditPlan(const Quantity& quantity, const AuditOptions& options);

  [[nodiscard]] std::size_t blocks() const { return blocks_.count; }
  /// The points of a block before its local search.
  [[nodiscard]] std::vector<Point> points(std::size_t block) const;
  /// The number of points of a block.
  [[nodiscard]] std::size_t size(std::size_t block) const { return blocks_.size(block); }
  /// The number of its points that are for the local search.
  [[nodiscard]] std::size_t searched(std::size_t block) const;
  /// The text from which a block draws.
  [[nodiscard]] std::string seed(std::size_t block) const;
  /// SHA-256 of everything that the blocks have in common.
  [[nodiscard]] std::string fingerprint() const;

  [[nodiscard]] const Quantity& quantity() const { return quantity_; }
  [[nodiscard]] const Ranges& ranges() const { return options_.ranges; }

 private:
  const Quantity& quantity_;
  const AuditOptions& options_;
  Blocks blocks_;
  std::size_t dense_;
  std::vector<Point> listed_;
};

/// Compares an evaluator's values with the reference.
class Comparator {
 public:
  /// The quantity must outlive the comparator. Without an evaluator it compares fast; the error that fast states for a
  /// value, where it states one, must then cover the error found.
  Comparator(const Quantity& quantity, Evaluator evaluator, const AuditOptions& options);

  /// Finds the errors at a batch of points; a point that either refuses has none.
  void operator()(std::span<const Point> points, std::span<std::optional<Finding>> findings) const;
  [[nodiscard]] std::optional<Finding> operator()(const Point& point) const;
  /// The same for a value that was computed before.
  [[nodiscard]] std::optional<Finding> operator()(const Point& point, double value) const;

 private:
  [[nodiscard]] std::vector<std::optional<double>> values(std::span<const Point> points) const;
  [[nodiscard]] std::optional<ref::Estimate> truth(const Point& point) const;
  [[nodiscard]] Finding finding(double value, const ref::Estimate& truth, const Point& point) const;
  [[nodiscard]] double allowed_ulps(double scale, const Point& point) const;
  [[nodiscard]] double tolerated_ulps(double scale) const;

  const Quantity& quantity_;
  Evaluator evaluator_;
  fast::Accuracy accuracy_;
  double promise_, absolute_;
  bool checks_own_error_;
};

/// The points at which both have a value, with the findings there.
struct Compared {
  std::vector<Point> points;
  std::vector<Finding> findings;
  std::size_t left_out = 0;
};

/// Those of the points that have a finding, and their tally.
Compared compared_of(std::vector<Point> points, const std::vector<std::optional<Finding>>& findings);
AuditTally tally_of(const Compared& compared);

/// Compares the points of one block, and searches around its worst few. The result does not depend on the number of
/// threads. The points before the search are added to `kept`, if it is there.
AuditTally audit_block(const AuditPlan& plan, const Comparator& comparator, std::size_t block,
                       const OnProgress& on_progress, Compared* kept);

/// The result of an audit, with the distribution over the arguments if points were kept. If the reference knows none of
/// the points, its BadInput for the first of them.
AuditResult result_of(const Quantity& quantity, const AuditOptions& options, const AuditTally& tally,
                      const Compared& kept, const Point& first);

}  // namespace nipref::verify
