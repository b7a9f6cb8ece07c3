#pragma once
#include <vector>

namespace nipref::fast {

/// A node of a rule on (0, 1). Both distances to the ends are kept, so that what is singular at an end can be
/// evaluated there without cancellation.
struct UnitNode {
  double from_left;   ///< x
  double from_right;  ///< 1 - x
  double weight;
};

/// Double-exponential rule on (0, 1), x = 1/(1 + exp(-pi sinh s)), for integrands that are analytic inside
/// and bounded or logarithmic at the ends. `tolerance`, dimensionless, in (0, 1): both the step and the cut
/// follow from it, for integrands with singularities no nearer to the interval than about a hundredth of
/// their distance from the nearer end.
std::vector<UnitNode> double_exponential_rule(double tolerance);

}  // namespace nipref::fast
