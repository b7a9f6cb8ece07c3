#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include <nipref/fast/nip/internal/sheet_part.hpp>
#include <nipref/fast/number/internal/gauss_legendre.hpp>

namespace nipref::fast {
namespace {

using internal::AlongWaves;
using internal::FarLoads;

/// Where a load counts as far: its residues need near_load_end, and a series over depths converges like 14^-n for loads
/// so far off.
constexpr double nearest_far = 1.5;
static_assert(nearest_far >= internal::near_load_end);

/// Nodes of a block and their distances from that end of it that is nearer to the contact's, as shares of its length:
/// e = w x^4 at the end, which takes the sting out of any exponent there.
GaussRule rule_at_end() {
  GaussRule rule = gauss_legendre(24);
  for (std::size_t j = 0; j < rule.at.size(); ++j) {
    const double x = rule.at[j];
    rule.at[j] = x * x * x * x;
    rule.weight[j] *= 4 * x * x * x;
  }
  return rule;
}
const GaussRule& rule_of(bool at_end) {
  static const GaussRule end = rule_at_end(), inside = gauss_legendre(12);
  return at_end ? end : inside;
}

FarLoads no_loads() {
  FarLoads none{AlongWaves(0), AlongWaves(0), 0};
  none.pressure.of.fill(0);
  none.shear.of.fill(0);
  return none;
}

/// As seen from further away.
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

/// Of a block's nodes to its ends.
struct WavesToEnds {
  std::vector<AlongWaves> outer, inner;
  AlongWaves across;

  WavesToEnds(const GaussRule& rule, double length) : across(length) {
    for (const double share : rule.at) {
      outer.emplace_back(length * share);
      inner.emplace_back(length * (1 - share));
    }
  }
};

double chebyshev_zero(std::size_t i, std::size_t count) {
  return std::cos(std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
}
/// Of the value at zero i in coefficient n.
double chebyshev_weight(std::size_t n, std::size_t i, std::size_t count) {
  const double all = static_cast<double>(count);
  return (n == 0 ? 1.0 : 2.0) / all *
         std::cos(std::numbers::pi * static_cast<double>(n) * (static_cast<double>(i) + 0.5) / all);
}
template <std::size_t count>
std::array<std::array<double, count>, count> chebyshev_weights() {
  std::array<std::array<double, count>, count> weights;
  for (std::size_t n = 0; n < count; ++n) {
    for (std::size_t i = 0; i < count; ++i) weights[n][i] = chebyshev_weight(n, i, count);
  }
  return weights;
}
template <std::size_t count>
std::array<double, count> chebyshev_polynomials(double x) {
  std::array<double, count> polynomials;
  polynomials[0] = 1;
  polynomials[1] = x;
  for (std::size_t n = 2; n < count; ++n) polynomials[n] = 2 * x * polynomials[n - 1] - polynomials[n - 2];
  return polynomials;
}

using Depths = std::array<double, SheetPartAcross::count>;
const Depths& depths_of_series() {
  static const Depths depths = [] {
    Depths result;
    for (std::size_t j = 0; j < result.size(); ++j)
      result[j] = std::sqrt((1 + chebyshev_zero(j, result.size())) / 2);
    return result;
  }();
  return depths;
}

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

ContactBlocks::Range ContactBlocks::near(double left, double right) const {
  Range range{0, count()};
  while (range.begin < range.end && left_end(range.begin + 1) <= left - nearest_far) ++range.begin;
  while (range.end > range.begin && left_end(range.end - 1) >= right + nearest_far) --range.end;
  return range;
}

SheetPart::SheetPart(const ContactBlocks& blocks, bool symmetric, const FaceTractions& traction)
    : blocks_(blocks) {
  if (symmetric) {
    for (std::size_t block = blocks.of_side(); block < blocks.count(); ++block) add_nodes(block, traction);
    mirror();
  } else {
    for (std::size_t block = 0; block < blocks.count(); ++block) add_nodes(block, traction);
  }
  sum_far();
}

void SheetPart::add_nodes(std::size_t block, const FaceTractions& traction) {
  const bool right = block >= blocks_.of_side();
  const std::size_t from_end = right ? blocks_.count() - 1 - block : block;
  const GaussRule& rule = rule_of(from_end == 0);
  const double length = blocks_.length(block);
  const double before =
      from_end == 0 ? 0 : blocks_.graded() + blocks_.inner() * (static_cast<double>(from_end) - 1);
  for (std::size_t j = 0; j < rule.at.size(); ++j) {
    const double e = before + length * rule.at[j], weight = length * rule.weight[j];
    const FaceTraction here = traction(right, e);
    nodes_.push_back({right ? blocks_.half_length() - e : e - blocks_.half_length(), weight * here.pressure,
                      weight * here.shear});
  }
}

/// Blocks from the left, the nodes of each in the order of its rule.
void SheetPart::mirror() {
  std::vector<Node> left;
  for (std::size_t block = blocks_.count(); block > blocks_.of_side(); --block) {
    const std::size_t first = blocks_.of_side();
    const std::size_t before = (block - 1 - first) * rule_of(false).at.size();
    const std::size_t count = rule_of(block == blocks_.count()).at.size();
    for (const Node& node : std::span(nodes_).subspan(before, count))
      left.push_back({-node.alpha, node.pressure, -node.shear});
  }
  nodes_.insert(nodes_.begin(), left.begin(), left.end());
}

std::span<const SheetPart::Node> SheetPart::nodes_of(const ContactBlocks::Range& blocks) const {
  const std::size_t at_end = rule_of(true).at.size(), inside = rule_of(false).at.size();
  const auto before = [&](std::size_t block) {
    if (block == 0) return std::size_t{0};
    return block == blocks_.count() ? nodes_.size() : at_end + (block - 1) * inside;
  };
  return std::span(nodes_).subspan(before(blocks.begin), before(blocks.end) - before(blocks.begin));
}

void SheetPart::sum_far() {
  const WavesToEnds at_end(rule_of(true), blocks_.graded()), inside(rule_of(false), blocks_.inner());
  const std::size_t count = blocks_.count();
  // With a block more.
  const auto joined = [&](const FarLoads& before, std::size_t block, bool seen_from_right) {
    const bool is_end = block == 0 || block + 1 == count;
    const WavesToEnds& waves = is_end ? at_end : inside;
    FarLoads sum = seen_from(before, waves.across);
    const std::vector<AlongWaves>& to =
        seen_from_right == (block >= blocks_.of_side()) ? waves.outer : waves.inner;
    const std::span<const Node> nodes = nodes_of({block, block + 1});
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      for (std::size_t n = 0; n < to[j].of.size(); ++n) {
        sum.pressure.of[n] += nodes[j].pressure * to[j].of[n];
        sum.shear.of[n] += nodes[j].shear * to[j].of[n];
      }
      sum.shear_force += nodes[j].shear;
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

void SheetPart::add(double alpha, const ContactBlocks::Range& near, const internal::StressesAtDepths& depths,
                    std::span<SheetStresses> sums) const {
  std::vector<internal::StressesBeside> one(sums.size());
  for (const Node& node : nodes_of(near)) {
    depths(alpha - node.alpha, one);
    for (std::size_t i = 0; i < sums.size(); ++i)
      sums[i] = sums[i] + node.pressure * one[i].normal + node.shear * one[i].shear;
  }
  if (near.begin > 0) {
    const AlongWaves waves(alpha - blocks_.left_end(near.begin));
    depths.add_far(seen_from(to_the_left_[near.begin], waves), 1, sums);
  }
  if (near.end < blocks_.count()) {
    const AlongWaves waves(blocks_.left_end(near.end) - alpha);
    depths.add_far(seen_from(to_the_right_[near.end], waves), -1, sums);
  }
}

SheetPartAcross::SheetPartAcross(const SheetPart& part, const ContactBlocks::Range& near, double alpha) {
  static const auto weights = chebyshev_weights<count>();
  static const internal::StressesAtDepths depths{depths_of_series()};
  std::array<SheetStresses, count> values{};
  part.add(alpha, near, depths, values);
  for (std::size_t j = 0; j < count; ++j) {
    values[j].shear /= depths_of_series()[j];
    for (std::size_t n = 0; n < count; ++n) coefficient_[n] = coefficient_[n] + weights[n][j] * values[j];
  }
}

void SheetPartAcross::add(double weight, const SheetPartAcross& other) {
  for (std::size_t n = 0; n < count; ++n) coefficient_[n] = coefficient_[n] + weight * other.coefficient_[n];
}

SheetStresses SheetPartAcross::at(double depth) const {
  const auto polynomials = chebyshev_polynomials<count>(2 * depth * depth - 1);
  SheetStresses sum{};
  for (std::size_t n = 0; n < count; ++n) sum = sum + polynomials[n] * coefficient_[n];
  sum.shear *= depth;
  return sum;
}

SheetPartBetween::SheetPartBetween(const SheetPart& part, const ContactBlocks::Range& near, double left,
                                   double right)
    : left_(left), length_(right - left) {
  static const auto weights = chebyshev_weights<count>();
  for (std::size_t i = 0; i < count; ++i) {
    const SheetPartAcross here(part, near, left + length_ * (1 + chebyshev_zero(i, count)) / 2);
    for (std::size_t m = 0; m < count; ++m) coefficient_[m].add(weights[m][i], here);
  }
}

SheetStresses SheetPartBetween::at(double alpha, double depth) const {
  const auto polynomials = chebyshev_polynomials<count>(2 * (alpha - left_) / length_ - 1);
  SheetPartAcross across;
  for (std::size_t m = 0; m < count; ++m) across.add(polynomials[m], coefficient_[m]);
  return across.at(depth);
}

}  // namespace nipref::fast
