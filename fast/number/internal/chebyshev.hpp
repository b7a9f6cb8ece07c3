#pragma once
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace nipref::fast::internal {

/// T_0 .. of 2 x - 1.
inline void shifted_chebyshev(double x, std::span<double> values) {
  const double t = 2 * x - 1;
  double before = t, now = 1;  // T_{-1} = T_1
  for (double& value : values) {
    value = now;
    now = 2 * t * now - std::exchange(before, now);
  }
}

/// Zero number i = 0 .. count - 1 of T_count(2 x - 1), rising, without cancellation near 0.
inline double shifted_chebyshev_zero(int i, int count) {
  return std::pow(std::sin((2 * i + 1) * std::numbers::pi / (4 * count)), 2);
}

}  // namespace nipref::fast::internal
