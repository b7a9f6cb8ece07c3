#include <nipref/verify/audit/internal/block.hpp>
#include <nipref/verify/audit/internal/sampling.hpp>
#include <nipref/verify/support/sha256.hpp>

namespace nipref::verify {
namespace {

// Shares of the points asked for.
constexpr double share_of_hard = 0.5;  // at most
constexpr double share_of_zeros = 0.1;
constexpr double share_of_round = 0.05;
constexpr double share_of_dense = 0.15;
constexpr double share_of_search = 0.1;

/// Blocks are smaller for a quantity whose own number of points is less than a block, as its points are slow, and a
/// process that is killed loses one block.
constexpr std::size_t slow_block = 64;

std::size_t share(double part, std::size_t points) {
  return static_cast<std::size_t>(part * static_cast<double>(points));
}

void append(std::vector<Point>& points, std::vector<Point> more) {
  points.insert(points.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// The listed points, which do not depend on the block.
std::vector<Point> listed(const Quantity& quantity, const AuditOptions& options) {
  const std::size_t wanted = options.points_of(quantity);
  const Ranges& ranges = options.ranges;
  Random random(fmt::format("{}/{}/listed", options.seed, quantity.drawn_for()));
  std::vector<Point> points = thinned(hard_points(quantity, ranges, random), share(share_of_hard, wanted));
  append(points, zero_points(quantity, ranges, share(share_of_zeros, wanted), random));
  append(points, thinned(round_points(quantity, ranges, random), share(share_of_round, wanted)));
  return points;
}

}  // namespace

AuditPlan::AuditPlan(const Quantity& quantity, const AuditOptions& options)
    : quantity_(quantity),
      options_(options),
      blocks_(options.points_of(quantity),
              quantity.audit_points < points_of_block ? std::min(slow_block, options.block) : options.block),
      dense_(share(share_of_dense, blocks_.items)),
      listed_(listed(quantity, options)) {}

std::size_t AuditPlan::searched(std::size_t block) const {
  return options_.search ? share(share_of_search, blocks_.size(block)) : 0;
}

std::string AuditPlan::seed(std::size_t block) const {
  return fmt::format("{}/{}/block/{}", options_.seed, quantity_.drawn_for(), block);
}

std::vector<Point> AuditPlan::points(std::size_t block) const {
  const Part part{block, blocks_.count};
  Random random(seed(block));
  std::vector<Point> points = part.taken(listed_);
  append(points, dense_points(quantity_, options_.ranges, dense_, random, part));
  const std::size_t planned = points.size() + searched(block);
  if (planned < blocks_.size(block))
    append(points, random_points(quantity_, options_.ranges, blocks_.size(block) - planned, random));
  append(points, part.taken(options_.more_points));
  return points;
}

std::string AuditPlan::fingerprint() const {
  std::string text = fmt::format("{} {} {} {} {} {}\n", sampler_version, blocks_.items, blocks_.count, dense_,
                                 options_.search, options_.seed);
  for (const auto* const list : {&listed_, &options_.more_points}) {
    for (const Point& point : *list) {
      for (const double number : point) text += fmt::format("{:a} ", number);
      text += '\n';
    }
  }
  return sha256(text);
}

}  // namespace nipref::verify
