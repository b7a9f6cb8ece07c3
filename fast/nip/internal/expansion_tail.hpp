#pragma once
#include <algorithm>
#include <cmath>

#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {

/// By what factor a term Chebyshev expansions on panels that double away from an end of width `end_panel`
/// (half-thicknesses) converge at best. The nearest singularity of the solution is a panel's length away: its
/// coefficients fall by 3 + sqrt 8, what follows from them by up to 8 (measured). Those of the kernels are two
/// half-thicknesses beside each point, which counts where the kernels are felt across a panel; that is approached
/// from above (measured: by a fifth).
inline double fastest_on_panels(double end_panel) {
  const double beside = 4 / end_panel;
  return std::min(8.0, 1.2 * (beside + std::hypot(1, beside)));
}

/// What the solution's expansions are about to leave out: the largest of the last three coefficients, for one of
/// them may be small by chance, each as it would be at the last place had it fallen by a usual factor a term; of
/// those expansions in which it is not lost in what the twins differ by. The first terms * expansions unknowns are
/// the coefficients, one expansion after the other.
double expansion_tail(const SolutionAndTwins& found, Eigen::Index terms, Eigen::Index expansions);

}  // namespace nipref::fast
