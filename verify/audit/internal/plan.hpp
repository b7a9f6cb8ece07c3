#pragma once
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <nipref/verify/audit/audit.hpp>

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

 private:
  const Quantity& quantity_;
  const AuditOptions& options_;
  Blocks blocks_;
  std::size_t dense_;
  std::vector<Point> listed_;
};

}  // namespace nipref::verify
