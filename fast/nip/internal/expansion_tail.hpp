#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {

/// Half-thicknesses: a panel that is no wider than this feels the kernels from end to end.
inline constexpr double widest_felt = 2.5;

/// The largest factor per term by which Chebyshev expansions converge on panels of the widths A/2, A/4, ... towards an
/// end. Two singularities limit it. That of the solution is one panel width away: the coefficients fall by 3 + sqrt 8 a
/// term, and functionals of the solution by up to 8 (measured). Those of the kernels are 2 half-thicknesses to the side
/// of each point; they limit the widest panel that feels the kernels from end to end. Measured factors approach this
/// second limit from above and exceed it by up to a fifth.
inline double fastest_on_panels(double half_length) {
  const double halvings = std::max(0.0, std::ceil(std::log2(half_length / widest_felt)));
  const double beside = 4 / (half_length * std::exp2(-halvings));
  return std::min(8.0, 1.2 * (beside + std::hypot(1, beside)));
}

/// The size of the first term that each of the solution's expansions leaves out: the largest of the last three
/// coefficients, scaled to the last place by a usual factor per term, because one of them may be small by chance. It is
/// 0 where it is below the spread of the twins. The first terms * expansions unknowns are the coefficients, one
/// expansion after the other.
std::vector<double> expansion_tails(const SolutionAndTwins& found, Eigen::Index terms,
                                    Eigen::Index expansions);

}  // namespace nipref::fast
