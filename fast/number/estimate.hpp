#pragma once
#include <array>
#include <cmath>

namespace nipref::fast {

/// A computed number and an estimate of its error in the same unit: |value - truth| <= error is expected, not
/// proven.
struct Estimate {
  double value;
  double error;
};

/// From three solutions whose terms grow by half each time: with the differences d0 and d1, a geometric
/// convergence has less than d1 d1/d0 left; the error is taken as 3 d1 min(1, d1/d0).
inline Estimate estimate_from_levels(const std::array<double, 3>& values) {
  const double before = std::fabs(values[1] - values[0]);
  const double change = std::fabs(values[2] - values[1]);
  return {values[2], 3 * change * (change < before ? change / before : 1)};
}

}  // namespace nipref::fast
