#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "fast/estimate.hpp"
#include "fast/surface_line.hpp"

namespace nipref::fast {

/// int f dpsi over half a turn for a vector f(Direction) that has this period: the trapezoidal rule, which
/// converges geometrically for analytic f, its nodes doubled until the estimated error is rounding of the
/// first component (which sets the scale), or 2^14 nodes are spent and the estimate says what is missing.
template <std::size_t count, typename Integrand>
std::array<Estimate, count> half_turn_integral(Integrand&& integrand) {
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  using Vector = std::array<double, count>;
  Vector sum{};
  const auto add_nodes = [&](int first, int step, int nodes) {
    for (int node = first; node < nodes; node += step) {
      const Vector term = integrand(Direction::of_angle(std::numbers::pi * node / nodes));
      for (std::size_t i = 0; i < count; ++i) sum[i] += term[i];
    }
  };
  std::array<std::array<double, 3>, count> levels{};
  std::array<Estimate, count> result{};
  for (int nodes = 8, level = 1; nodes <= 1 << 14; nodes *= 2, ++level) {
    add_nodes(level == 1 ? 0 : 1, level == 1 ? 1 : 2, nodes);
    double largest = 0;
    for (std::size_t i = 0; i < count; ++i) {
      levels[i] = {levels[i][1], levels[i][2], sum[i] * std::numbers::pi / nodes};
      result[i] = estimate_from_levels(levels[i]);
      largest = std::max(largest, result[i].error);
    }
    if (level >= 3 && largest <= rounding * std::fabs(result[0].value)) break;
  }
  for (Estimate& component : result) component.error += rounding * std::fabs(result[0].value);
  return result;
}

}  // namespace nipref::fast
