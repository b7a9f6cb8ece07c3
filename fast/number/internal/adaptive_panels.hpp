#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast::internal {

struct Subinterval {
  double lower, upper;

  [[nodiscard]] double middle() const { return (lower + upper) / 2; }
};

inline constexpr std::size_t nodes_in_a_panel = 16;

/// Calls visit(x, weight) for the Gauss-Legendre nodes of one panel, in ascending order.
template <typename Visit>
void visit_nodes(Subinterval panel, Visit&& visit) {
  using Rule = boost::math::quadrature::gauss<double, nodes_in_a_panel>;
  const double middle = panel.middle(), half = (panel.upper - panel.lower) / 2;
  const auto &places = Rule::abscissa(), &weights = Rule::weights();
  for (std::size_t i = places.size(); i-- > 0;) visit(middle - half * places[i], half * weights[i]);
  for (std::size_t i = 0; i < places.size(); ++i) visit(middle + half * places[i], half * weights[i]);
}

template <std::size_t count>
using Components = Eigen::Array<double, static_cast<int>(count), 1>;

/// The integrals of a vector f and of |f| over one panel, by the Gauss-Legendre rule. The variation, the sum of the sizes
/// of the changes of f from node to node, is about the integral of |f'|.
template <std::size_t count>
struct PanelSum {
  Subinterval panel;
  Components<count> value = Components<count>::Zero(), magnitude = value, variation = value;

  template <typename Integrand>
  PanelSum(Integrand& integrand, Subinterval over) : panel(over) {
    std::optional<Components<count>> before;
    visit_nodes(panel, [&](double x, double weight) {
      const std::array<double, count> terms = integrand(x);
      const Components<count> here = Eigen::Map<const Components<count>>(terms.data());
      value += weight * here;
      magnitude += weight * here.abs();
      if (before) variation += (here - *before).abs();
      before = here;
    });
  }
};

/// The integral of a vector f, and the panels that it needs: with them the rule's error in each component is about the
/// rounding error of that component's absolute integral.
template <std::size_t count>
struct AdaptedPanels {
  std::vector<Subinterval> panels;
  std::array<Estimate, count> integral{};
};

/// Integrates f, which maps a number to a std::array<double, count>. A panel is halved until its halves agree with it;
/// this grades the panels towards nearby poles, kinks and jumps. If f is noisier than rounding, the halving stops at
/// 2^14 nodes, and the errors include the disagreement that is left.
template <std::size_t count, typename Integrand>
AdaptedPanels<count> adapt_panels(Integrand&& integrand, double lower, double upper) {
  // A weighted value has four roundings u = 2^-53, and the sums over both halves of a panel have 16 more: 20 u of the
  // panel's absolute integral. The sum of n panels has n^(1/2) u as independent errors, 12 u for 144 panels. As
  // independent errors, 20 u make a panel and its halves disagree by 40^(1/2) u = 6.3 u. If they disagree by more, 9 u,
  // the rule's error shows. Halving at least halves it, so that what they disagree by covers what the halves miss.
  // A node has up to 5 u of the panel's end that is farther from 0: one in the panel's middle, two in the distance from
  // it, one in their sum, and one for an f that takes the node's cosine and sine. They count where f varies. Other errors
  // of f are the caller's.
  constexpr double tolerance = 1e-15, rounding = 32 * 0x1p-53, of_node = 5 * 0x1p-53;
  constexpr std::size_t most_nodes = 1 << 14;
  const double middle = Subinterval{lower, upper}.middle();
  std::vector<PanelSum<count>> pending{{integrand, {lower, middle}}, {integrand, {middle, upper}}};
  std::size_t nodes = 2 * nodes_in_a_panel;
  // The integral of |f|, as far as it is known.
  Components<count> magnitude = pending[0].magnitude + pending[1].magnitude;
  Components<count> value = Components<count>::Zero(), error = value;
  AdaptedPanels<count> result;
  while (!pending.empty()) {
    std::vector<PanelSum<count>> unconfirmed;
    const bool enough = nodes >= most_nodes;
    const Components<count> tolerated = tolerance * magnitude;
    for (const PanelSum<count>& whole : pending) {
      const double halfway = whole.panel.middle();
      const PanelSum<count> left(integrand, {whole.panel.lower, halfway}),
          right(integrand, {halfway, whole.panel.upper});
      nodes += 2 * nodes_in_a_panel;
      magnitude += left.magnitude + right.magnitude - whole.magnitude;
      const Components<count> sum = left.value + right.value, missing = (sum - whole.value).abs();
      if (enough || (missing <= tolerated).all()) {
        result.panels.push_back(whole.panel);
        value += sum;
        const double farthest = std::max(std::fabs(whole.panel.lower), std::fabs(whole.panel.upper));
        error += missing + of_node * farthest * (left.variation + right.variation);
      } else {
        unconfirmed.insert(unconfirmed.end(), {left, right});
      }
    }
    pending = std::move(unconfirmed);
  }
  error += rounding * magnitude;
  for (int i = 0; i < value.size(); ++i) result.integral[static_cast<std::size_t>(i)] = {value[i], error[i]};
  return result;
}

}  // namespace nipref::fast::internal
