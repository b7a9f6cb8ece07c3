#pragma once
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "fast/estimate.hpp"

namespace nipref::fast::internal {

struct Panel {
  double lower, upper;

  [[nodiscard]] double middle() const { return (lower + upper) / 2; }
};

inline constexpr std::size_t nodes_in_a_panel = 16;

/// The nodes of Gauss and Legendre on one panel: visit(x, weight).
template <typename Visit>
void visit_nodes(Panel panel, Visit&& visit) {
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
  Panel panel;
  std::array<double, count> value{}, magnitude{};

  template <typename Integrand>
  PanelSum(Integrand& integrand, Panel over) : panel(over) {
    visit_nodes(panel, [&](double x, double weight) {
      const std::array<double, count> term = integrand(x);
      for (std::size_t i = 0; i < count; ++i) {
        value[i] += weight * term[i];
        magnitude[i] += weight * std::fabs(term[i]);
      }
    });
  }
};

/// The integral of a vector f, and panels on which the rule gives each of its components to rounding of that
/// component's absolute integral.
template <std::size_t count>
struct AdaptedPanels {
  std::vector<Panel> panels;
  std::array<Estimate, count> integral{};
};

/// f is a functor of a number that returns a std::array<double, count>. Panels are halved until the halves
/// confirm the whole: towards poles near the interval, kinks and jumps as often as it takes. Where f is
/// noisier than rounding the halving stops at 2^14 nodes, and the estimates say what is missing.
template <std::size_t count, typename Integrand>
AdaptedPanels<count> adapt_panels(Integrand&& integrand, double lower, double upper) {
  constexpr double tolerance = 1e-15, rounding = 16 * std::numeric_limits<double>::epsilon();
  constexpr std::size_t most_nodes = 1 << 14;
  using Sum = PanelSum<count>;
  const double middle = Panel{lower, upper}.middle();
  std::vector<Sum> pending{{integrand, {lower, middle}}, {integrand, {middle, upper}}};
  std::size_t nodes = 2 * nodes_in_a_panel;
  std::array<double, count> magnitude{};  // of the whole, as well as it is known
  for (const Sum& sum : pending)
    for (std::size_t i = 0; i < count; ++i) magnitude[i] += sum.magnitude[i];

  AdaptedPanels<count> result;
  while (!pending.empty()) {
    std::vector<Sum> unconfirmed;
    const auto scale = magnitude;
    const bool enough = nodes >= most_nodes;
    for (const Sum& whole : pending) {
      const Panel panel = whole.panel;
      const Sum left(integrand, {panel.lower, panel.middle()}),
          right(integrand, {panel.middle(), panel.upper});
      nodes += 2 * nodes_in_a_panel;
      std::array<Estimate, count> both;
      bool confirmed = true;
      for (std::size_t i = 0; i < count; ++i) {
        both[i].value = left.value[i] + right.value[i];
        both[i].error = std::fabs(both[i].value - whole.value[i]);
        confirmed = confirmed && both[i].error <= tolerance * scale[i];
        magnitude[i] += left.magnitude[i] + right.magnitude[i] - whole.magnitude[i];
      }
      if (!confirmed && !enough) {
        unconfirmed.insert(unconfirmed.end(), {left, right});
        continue;
      }
      result.panels.push_back(panel);
      for (std::size_t i = 0; i < count; ++i) {
        result.integral[i].value += both[i].value;
        result.integral[i].error += both[i].error;
      }
    }
    pending = std::move(unconfirmed);
  }
  for (std::size_t i = 0; i < count; ++i) result.integral[i].error += rounding * magnitude[i];
  return result;
}

}  // namespace nipref::fast::internal
