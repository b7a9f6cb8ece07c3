#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/fast/number/internal/double_exponential.hpp>

namespace nipref::fast {

std::vector<UnitNode> double_exponential_rule(double tolerance, double degree) {
  const double nats = -std::log(tolerance);
  const double end = std::asinh((nats + std::log(nats + 1)) / std::numbers::pi);
  // The step that the tolerance requires also suffices for a polynomial factor of degree nats/2.
  const double more = std::max(degree - nats / 2, 0.0) * end / std::numbers::pi;
  const int half_count = static_cast<int>(std::ceil(1.1 * nats + more));
  const double step = end / half_count;
  std::vector<UnitNode> nodes;
  for (int i = -half_count; i <= half_count; ++i) {
    const double growth = std::exp(std::numbers::pi * std::sinh(i * step));
    const double right = 1 / (1 + growth);
    const double left = growth / (1 + growth);
    nodes.push_back({left, right, step * std::numbers::pi * std::cosh(i * step) * left * right});
  }
  return nodes;
}

}  // namespace nipref::fast
