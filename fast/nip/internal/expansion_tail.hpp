#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {

/// In half-thicknesses: panels in which the kernels are felt from end to end are no wider.
inline constexpr double widest_felt = 2.5;

/// By what factor a term Chebyshev expansions on panels that double away from an end, A/2, A/4 ... wide, converge at
/// best. The nearest singularity of the solution is a panel's length away: its coefficients fall by 3 + sqrt 8, what
/// follows from them by up to 8 (measured). Those of the kernels are two half-thicknesses beside each point, nearest
/// to the widest panel that is felt from end to end; that is approached from above (measured: by a fifth).
inline double fastest_on_panels(double half_length) {
  const double halvings = std::max(0.0, std::ceil(std::log2(half_length / widest_felt)));
  const double beside = 4 / (half_length * std::exp2(-halvings));
  return std::min(8.0, 1.2 * (beside + std::hypot(1, beside)));
}

/// What each of the solution's expansions is about to leave out: the largest of the last three coefficients, for one of
/// them may be small by chance, each as it would be at the last place had it fallen by a usual factor a term; 0 where it
/// is lost in what the twins differ by. The first terms * expansions unknowns are the coefficients, one expansion after
/// the other.
std::vector<double> expansion_tails(const SolutionAndTwins& found, Eigen::Index terms,
                                    Eigen::Index expansions);

}  // namespace nipref::fast
