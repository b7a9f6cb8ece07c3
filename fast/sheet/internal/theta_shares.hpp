#pragma once

namespace nipref::fast::internal {

/// theta1 and theta2 over their sum N, which do not depend on Young's modulus.
struct Shares {
  double theta1, theta2;
};
/// The shares by formulas without the cancellation in 1 - poisson^2.
inline Shares shares_of(double poisson) {
  return {1 / (2 * (1 - poisson)), (1 - 2 * poisson) / (2 * (1 - poisson))};
}

}  // namespace nipref::fast::internal
