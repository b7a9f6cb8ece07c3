#pragma once
#include <vector>

namespace nipref::fast {

/// A node of a rule on (0, 1), with its distances from both ends, so that an integrand which is singular at an end
/// can be evaluated there without cancellation.
struct UnitNode {
  double from_left;   ///< x
  double from_right;  ///< 1 - x
  double weight;
};

/// Double-exponential rule on (0, 1), x = 1/(1 + exp(-pi sinh s)), for integrands that are analytic inside and
/// bounded or logarithmic at the ends, times a polynomial of a degree >= 0. `tolerance`, dimensionless, in (0, 1),
/// determines the step and the truncation, for integrands whose singularities are at least about a hundredth as far from
/// the interval as from its nearer end. In s a polynomial of degree n grows like e^(2 n |Im s|) at most, which its share of
/// the step takes back.
std::vector<UnitNode> double_exponential_rule(double tolerance, double degree = 0);

}  // namespace nipref::fast
