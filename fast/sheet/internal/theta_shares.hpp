#pragma once

namespace nipref::fast::internal {

/// theta1/N without the cancellation of 1 - poisson^2, and theta2/N: they do not depend on Young's modulus.
inline double theta1_share(double poisson) { return 1 / (2 * (1 - poisson)); }
inline double theta2_share(double poisson) { return (1 - 2 * poisson) / (2 * (1 - poisson)); }

}  // namespace nipref::fast::internal
