#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/fast/elastic_nip/internal/operator.hpp>
#include <nipref/fast/number/internal/cache.hpp>
#include <nipref/fast/number/internal/gauss_legendre.hpp>

namespace nipref::fast {
namespace {

constexpr double pi = std::numbers::pi;

/// I3 - beta I2 at signed distances.
std::vector<double> coupling(const std::vector<double>& alpha, double beta, CountedKernels& kernels) {
  std::vector<double> values = kernels.I3(alpha);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] -= std::copysign(beta * pi / 2, alpha[i]);
  return values;
}

std::vector<UnitNode> gauss_rule(const int& count) {
  const GaussRule rule = gauss_legendre(count);
  std::vector<UnitNode> nodes;
  for (std::size_t i = 0; i < rule.at.size(); ++i)
    nodes.push_back({rule.at[i], 1 - rule.at[i], rule.weight[i]});
  return nodes;
}

/// The number of Gauss nodes for a polynomial times a kernel whose singularity is at least the piece's width away: on
/// the piece [-1, 1] at 3, hence on a Bernstein ellipse of 3 + sqrt 8. The kernel decays within 16 half-thicknesses.
int gauss_nodes(int degree, double width, double tolerance) {
  return static_cast<int>(degree / 2.0 + 2 - std::log(tolerance) / 3.5 + std::min(width, 16.0));
}

}  // namespace

/// Whether the kernels are as smooth on the piece as a polynomial.
bool ElasticNipOperator::is_far(double point, double left, double right) const {
  const double gap = std::max(left - point, point - right), image = 2 * half_length_ - point;
  return std::min(gap, image - right) >= right - left;
}

/// Signed distances: near = y - s = e_s - e_y, formed from distances to the end of the piece where that end
/// is the point; far = y + s.
void ElasticNipOperator::append_nodes(const std::vector<UnitNode>& rule, double point, double left,
                                      double right, std::vector<Influence>& nodes, std::vector<double>& near,
                                      std::vector<double>& far) const {
  const double width = right - left;
  for (const UnitNode& node : rule) {
    const double e = left == 0 || node.from_left < node.from_right ? left + width * node.from_left
                                                                   : right - width * node.from_right;
    const double distance = point <= left ? (left - point) + width * node.from_left
                                          : -((point - right) + width * node.from_right);
    nodes.push_back({e, width * node.weight, 0, 0, 0, 0});
    near.push_back(distance);
    far.push_back((half_length_ - point) + (half_length_ - e));
  }
}

/// The ends of the pieces of [left, right], which may be thousands long, such that on each piece the kernels change on
/// one scale only. The cuts are at the point itself and where the kernels of the point and of its mirror image have
/// decayed.
std::vector<double> ElasticNipOperator::cuts(double point, double left, double right) const {
  const double image = 2 * half_length_ - point;
  std::vector<double> cuts{left, right};
  for (const double cut : {point, point - 5, point + 5, point - 18, point + 18, image - 5, image - 18}) {
    if (left < cut && cut < right && (cut == point || right - left > 8)) cuts.push_back(cut);
  }
  std::ranges::sort(cuts);
  cuts.erase(std::ranges::unique(cuts).begin(),
             cuts.end());  // a piece without length would hold the point itself
  return cuts;
}

std::vector<Influence> ElasticNipOperator::influences(double point, double left, double right,
                                                      Couplings wanted, std::optional<int> degree) const {
  static Cache<int, std::vector<UnitNode>> gauss_rules(gauss_rule);
  std::vector<Influence> nodes;
  std::vector<double> near, far;
  if (degree && is_far(point, left, right)) {
    const auto rule = gauss_rules.at(gauss_nodes(*degree, right - left, tolerance_));
    append_nodes(*rule, point, left, right, nodes, near, far);
  } else {
    const std::vector<double> ends = cuts(point, left, right);
    for (std::size_t i = 1; i < ends.size(); ++i)
      append_nodes(rule_, point, ends[i - 1], ends[i], nodes, near, far);
  }
  if (wanted.normal_by_pressure) {
    const auto here = kernels_.I1(near), mirror = kernels_.I1(far);
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].normal_by_pressure = (here[i] + mirror[i]) / pi;
  }
  if (wanted.normal_by_shear || wanted.tangential_by_pressure) {
    const auto here = coupling(near, beta_, kernels_), mirror = coupling(far, beta_, kernels_);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (wanted.normal_by_shear) nodes[i].normal_by_shear = -(here[i] - mirror[i]) / pi;
      if (wanted.tangential_by_pressure) nodes[i].tangential_by_pressure = (here[i] + mirror[i]) / pi;
    }
  }
  if (wanted.tangential_by_shear) {
    const auto here = kernels_.I6(near), mirror = kernels_.I6(far);
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].tangential_by_shear = (here[i] - mirror[i]) / pi;
  }
  return nodes;
}

}  // namespace nipref::fast
