#pragma once
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <nipref/verify/audit/audit.hpp>

namespace nipref::verify {

/// How many blocks so many items are dealt out to, and how many of them each holds: they differ by one at most.
struct Blocks {
  std::size_t items, count;

  /// Of at most `most` items each; one at least.
  Blocks(std::size_t all, std::size_t most) : items(all), count(all == 0 ? 1 : (all - 1) / most + 1) {}
  [[nodiscard]] std::size_t size(std::size_t block) const {
    return items / count + (block < items % count ? 1 : 0);
  }
  /// The number of its first item.
  [[nodiscard]] std::size_t first(std::size_t block) const {
    return block * (items / count) + std::min(block, items % count);
  }
};

/// Which points an audit looks at, in blocks that need nothing of each other: who does a block draws its points from its
/// own text, "seed/I1/block/17", so that they are the same whoever does the others. What is listed (hard cases, zeros,
/// round arguments, the caller's own points) is listed once, from the text "seed/I1/listed", and dealt out.
/// Memory: that list, which does not grow with the points of the audit, and one block.
class AuditPlan {
 public:
  /// `quantity` and what `options` refer to must outlive it.
  AuditPlan(const Quantity& quantity, const AuditOptions& options);

  [[nodiscard]] std::size_t blocks() const { return blocks_.count; }
  /// Of one block, before its local search.
  [[nodiscard]] std::vector<Point> points(std::size_t block) const;
  /// How many points of one block were asked for.
  [[nodiscard]] std::size_t size(std::size_t block) const { return blocks_.size(block); }
  /// How many of them are for its local search.
  [[nodiscard]] std::size_t searched(std::size_t block) const;
  /// The text from which a block draws.
  [[nodiscard]] std::string seed(std::size_t block) const;
  /// SHA-256 of all that blocks have in common.
  [[nodiscard]] std::string fingerprint() const;

 private:
  const Quantity& quantity_;
  const AuditOptions& options_;
  Blocks blocks_;
  std::size_t dense_;
  std::vector<Point> listed_;
};

}  // namespace nipref::verify
