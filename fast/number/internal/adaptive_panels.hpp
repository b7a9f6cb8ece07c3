#pragma once
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <nipref/fast/number/estimate.hpp>

namespace nipref::fast::internal {

struct Subinterval {
  double lower, upper;

  [[nodiscard]] double middle() const { return (lower + upper) / 2; }
};

inline constexpr std::size_t nodes_in_a_panel = 16;

/// Calls visit(x, weight) for the Gauss-Legendre nodes of one panel.
template <typename Visit>
void visit_nodes(Subinterval panel, Visit&& visit) {
  using Rule = boost::math::quadrature::gauss<double, nodes_in_a_panel>;
  const double middle = panel.middle(), half = (panel.upper - panel.lower) / 2;
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    const double offset = half * Rule::abscissa()[i], weight = half * Rule::weights()[i];
    visit(middle - offset, weight);
    visit(middle + offset, weight);
  }
}

/// One panel's part of int f and int |f| for a vector f.
template <std::size_t count>
struct PanelSum {
  Subinterval panel;
  std::array<double, count> value{}, magnitude{};

  template <typename Integrand>
  PanelSum(Integrand& integrand, Subinterval over) : panel(over) {
    visit_nodes(panel, [&](double x, double weight) {
      const std::array<double, count> term = integrand(x);
      for (std::size_t i = 0; i < count; ++i) {
        value[i] += weight * term[i];
        magnitude[i] += weight * std::fabs(term[i]);
      }
    });
  }
};

/// A panel compared with its two halves.
template <std::size_t count>
struct HalvedPanel {
  PanelSum<count> left, right;
  std::array<Estimate, count> integral{};  ///< sum of the halves; the error is its difference from the whole

  template <typename Integrand>
  HalvedPanel(Integrand& integrand, const PanelSum<count>& whole)
      : left(integrand, {whole.panel.lower, whole.panel.middle()}),
        right(integrand, {whole.panel.middle(), whole.panel.upper}) {
    for (std::size_t i = 0; i < count; ++i) {
      const double sum = left.value[i] + right.value[i];
      integral[i] = {sum, std::fabs(sum - whole.value[i])};
    }
  }

  [[nodiscard]] bool confirms_whole(const std::array<double, count>& tolerated) const {
    for (std::size_t i = 0; i < count; ++i)
      if (!(integral[i].error <= tolerated[i])) return false;
    return true;
  }
};

/// The integral of a vector f, and panels on which the rule gives each of its components to rounding of that
/// component's absolute integral.
template <std::size_t count>
struct AdaptedPanels {
  std::vector<Subinterval> panels;
  std::array<Estimate, count> integral{};

  void add(Subinterval panel, const std::array<Estimate, count>& part) {
    panels.push_back(panel);
    for (std::size_t i = 0; i < count; ++i) {
      integral[i].value += part[i].value;
      integral[i].error += part[i].error;
    }
  }
};

/// f maps a number to a std::array<double, count>. A panel is halved until its halves agree with it, which grades the
/// panels towards nearby poles, kinks and jumps. Where f has more noise than rounding, the halving stops at 2^14
/// nodes, and the errors say how much is missing.
template <std::size_t count, typename Integrand>
AdaptedPanels<count> adapt_panels(Integrand&& integrand, double lower, double upper) {
  constexpr double tolerance = 1e-15, rounding = 16 * std::numeric_limits<double>::epsilon();
  constexpr std::size_t most_nodes = 1 << 14;
  const double middle = Subinterval{lower, upper}.middle();
  std::vector<PanelSum<count>> pending{{integrand, {lower, middle}}, {integrand, {middle, upper}}};
  std::size_t nodes = 2 * nodes_in_a_panel;
  std::array<double, count> magnitude{};  // the integral of |f|, as far as it is known
  const auto count_in = [&magnitude](const PanelSum<count>& sum, double sign) {
    for (std::size_t i = 0; i < count; ++i) magnitude[i] += sign * sum.magnitude[i];
  };
  for (const auto& sum : pending) count_in(sum, 1);

  AdaptedPanels<count> result;
  while (!pending.empty()) {
    std::vector<PanelSum<count>> unconfirmed;
    const bool enough = nodes >= most_nodes;
    auto tolerated = magnitude;
    for (double& each : tolerated) each *= tolerance;
    for (const PanelSum<count>& whole : pending) {
      const HalvedPanel<count> halves(integrand, whole);
      nodes += 2 * nodes_in_a_panel;
      count_in(whole, -1);
      count_in(halves.left, 1);
      count_in(halves.right, 1);
      if (enough || halves.confirms_whole(tolerated)) {
        result.add(whole.panel, halves.integral);
      } else {
        unconfirmed.insert(unconfirmed.end(), {halves.left, halves.right});
      }
    }
    pending = std::move(unconfirmed);
  }
  for (std::size_t i = 0; i < count; ++i) result.integral[i].error += rounding * magnitude[i];
  return result;
}

}  // namespace nipref::fast::internal
