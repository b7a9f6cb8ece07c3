#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <ranges>
#include <utility>

#include <nipref/fast/nip/internal/sheet_part.hpp>
#include <nipref/fast/number/internal/gauss_legendre.hpp>

namespace nipref::fast {
namespace {

using internal::AlongWaves;
using internal::FarLoads;

/// The distance from which on a load counts as far: sums over residues need near_load_end.
constexpr double nearest_far = 1.5;
static_assert(nearest_far >= internal::near_load_end);

/// Of a block, at most a half-thickness long. On the ellipse through the next singularity, 2 i away, Chebyshev
/// coefficients fall by 8 a degree.
constexpr std::size_t nodes_of_block = 18;
const GaussRule& rule_of_block() {
  static const GaussRule rule = gauss_legendre(nodes_of_block);
  return rule;
}

FarLoads no_loads() {
  FarLoads none{AlongWaves(0), AlongWaves(0), 0};
  none.pressure.of.fill(0);
  none.shear.of.fill(0);
  return none;
}

/// The coefficients for places that are further away.
FarLoads seen_from(const FarLoads& loads, const AlongWaves& further) {
  FarLoads seen = no_loads();
  seen.pressure.count = seen.shear.count = further.count;
  for (std::size_t n = 0; n < static_cast<std::size_t>(further.count); ++n) {
    seen.pressure.of[n] = loads.pressure.of[n] * further.of[n];
    seen.shear.of[n] = loads.shear.of[n] * further.of[n];
  }
  seen.shear_force = loads.shear_force;
  return seen;
}

/// The residues' waves from a block's nodes to its ends.
struct WavesToEnds {
  std::vector<AlongWaves> outer, inner;
  AlongWaves across;

  explicit WavesToEnds(double length) : across(length) {
    for (const double share : rule_of_block().at) {
      outer.emplace_back(length * share);
      inner.emplace_back(length * (1 - share));
    }
  }
};

}  // namespace

ContactBlocks::ContactBlocks(double half_length)
    : half_length_(half_length), graded_(std::min(half_length, 1.0)) {
  const double rest = half_length - graded_, pieces = std::ceil(rest);
  of_side_ = 1 + static_cast<std::size_t>(pieces);
  inner_ = pieces == 0 ? 0 : rest / pieces;
}

double ContactBlocks::left_end(std::size_t block) const {
  if (block == 0) return -half_length_;
  if (block == count()) return half_length_;
  return inner_ * (static_cast<double>(block) - static_cast<double>(of_side_));
}

ContactBlocks::Range ContactBlocks::near(double alpha, double reach) const {
  const auto first_not = [&](const auto& is_before) {
    return *std::ranges::partition_point(std::views::iota(std::size_t{0}, count()), is_before);
  };
  const std::size_t begin =
      first_not([&](std::size_t block) { return left_end(block + 1) <= alpha - reach; });
  const std::size_t end = first_not([&](std::size_t block) { return left_end(block) < alpha + reach; });
  return {begin, std::max(begin, end)};
}

SheetPart::SheetPart(const ContactBlocks& blocks, bool symmetric, const LoadsOfBlock& loads)
    : blocks_(blocks) {
  for (std::size_t block = symmetric ? blocks.of_side() : 0; block < blocks.count(); ++block)
    add_nodes(block, loads);
  if (symmetric) mirror();
  sum_far();
}

/// The polynomial through the nodes t_j that is 1 at one of them and 0 at the others is w_j sum_k (2 k + 1) P_k(t_j) P_k.
void SheetPart::add_nodes(std::size_t block, const LoadsOfBlock& loads) {
  const bool right = block >= blocks_.of_side();
  const std::size_t from_end = right ? blocks_.count() - 1 - block : block;
  const double length = blocks_.length(block);
  const double before =
      from_end == 0 ? 0 : blocks_.graded() + blocks_.inner() * (static_cast<double>(from_end) - 1);
  std::array<double, nodes_of_block> polynomials{};
  std::array<FaceTraction, nodes_of_block> sums{};
  for (const LoadOnFace& load : loads(right, from_end)) {
    legendre(2 * (load.e - before) / length - 1, polynomials);
    for (std::size_t k = 0; k < nodes_of_block; ++k) sums[k].add(polynomials[k], load.force);
  }
  const GaussRule& rule = rule_of_block();
  for (std::size_t j = 0; j < nodes_of_block; ++j) {
    const double e = before + length * rule.at[j];
    Node node{right ? blocks_.half_length() - e : e - blocks_.half_length(), {0, 0}};
    legendre(2 * rule.at[j] - 1, polynomials);
    for (std::size_t k = 0; k < nodes_of_block; ++k)
      node.force.add(rule.weight[j] * static_cast<double>(2 * k + 1) * polynomials[k], sums[k]);
    nodes_.push_back(node);
  }
}

/// The blocks are in order from the left, the nodes of each in the order of their distances from the contact's end.
void SheetPart::mirror() {
  std::vector<Node> left;
  for (std::size_t first = nodes_.size(); first > 0; first -= nodes_of_block) {
    for (const Node& node : std::span(nodes_).subspan(first - nodes_of_block, nodes_of_block))
      left.push_back({-node.alpha, {node.force.pressure, -node.force.shear}});
  }
  nodes_.insert(nodes_.begin(), left.begin(), left.end());
}

std::span<const SheetPart::Node> SheetPart::nodes_of(const ContactBlocks::Range& blocks) const {
  return std::span(nodes_).subspan(nodes_of_block * blocks.begin,
                                   nodes_of_block * (blocks.end - blocks.begin));
}

void SheetPart::sum_far() {
  const WavesToEnds at_end(blocks_.graded()), inside(blocks_.inner());
  const std::size_t count = blocks_.count();
  // The coefficients with one more block.
  const auto joined = [&](const FarLoads& before, std::size_t block, bool seen_from_right) {
    const bool is_end = block == 0 || block + 1 == count;
    const WavesToEnds& waves = is_end ? at_end : inside;
    FarLoads sum = seen_from(before, waves.across);
    const std::vector<AlongWaves>& to =
        seen_from_right == (block >= blocks_.of_side()) ? waves.outer : waves.inner;
    const std::span<const Node> nodes = nodes_of({block, block + 1});
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      for (std::size_t n = 0; n < to[j].of.size(); ++n) {
        sum.pressure.of[n] += nodes[j].force.pressure * to[j].of[n];
        sum.shear.of[n] += nodes[j].force.shear * to[j].of[n];
      }
      sum.shear_force += nodes[j].force.shear;
    }
    return sum;
  };
  to_the_left_.assign(count + 1, no_loads());
  to_the_right_ = to_the_left_;
  for (std::size_t block = 0; block < count; ++block)
    to_the_left_[block + 1] = joined(to_the_left_[block], block, true);
  for (std::size_t block = count; block > 0; --block)
    to_the_right_[block - 1] = joined(to_the_right_[block], block - 1, false);
}

ContactBlocks::Range SheetPart::near(double alpha) const { return blocks_.near(alpha, nearest_far); }

template <class Field>
Field SheetPart::under_all(double alpha, const auto& there) const {
  const ContactBlocks::Range seen = near(alpha);
  Field sum{};
  for (const Node& node : nodes_of(seen)) {
    const auto one = there.beside(alpha - node.alpha);
    sum = sum + node.force.pressure * one.normal + node.force.shear * one.shear;
  }
  if (seen.begin > 0) {
    const AlongWaves further(alpha - blocks_.left_end(seen.begin));
    sum = sum + there.far(seen_from(to_the_left_[seen.begin], further), 1);
  }
  if (seen.end < blocks_.count()) {
    const AlongWaves further(blocks_.left_end(seen.end) - alpha);
    sum = sum + there.far(seen_from(to_the_right_[seen.end], further), -1);
  }
  return sum;
}

SheetStresses SheetPart::at(double alpha, double depth) const {
  return under_all<SheetStresses>(alpha, internal::StressesAtDepth(depth));
}

internal::FromFace SheetPart::from_face(double alpha, double depth, const internal::Shares& share) const {
  return under_all<internal::FromFace>(alpha, internal::DisplacementsFromFace(depth, share));
}

}  // namespace nipref::fast
