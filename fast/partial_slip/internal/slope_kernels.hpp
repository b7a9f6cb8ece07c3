#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

namespace nipref::fast {

/// U = (I1/pi)', V = (I3/pi)' and S = (I6(alpha, 0)/pi)', the slopes of the sheet's displacements over N under line loads,
/// and their derivatives, for |alpha| up to a longest distance. What they have beyond -1/(pi alpha) in U and S is analytic
/// for |Im alpha| < 2: Chebyshev series on intervals of length 1 fall by ((sqrt 17 + 4)/1)^-k, to 1e-16 in 18 terms.
class SlopeKernels {
 public:
  /// U, V, S and nothing.
  using Values = Eigen::Array4d;

  explicit SlopeKernels(double longest);

  [[nodiscard]] Values at(double alpha) const;
  [[nodiscard]] Values derivatives(double alpha) const;

 private:
  static constexpr int terms = 20;
  using Series = std::array<Values, terms>;
  std::vector<Series> values_, derivatives_;  ///< about the whole numbers
};

}  // namespace nipref::fast
