#pragma once
#include <vector>

namespace nipref::fast {

/// A node of a rule on (0, 1), by its distances from both ends. With them an integrand that is singular at an end can
/// be evaluated near it without cancellation.
struct UnitNode {
  double from_left;   ///< x
  double from_right;  ///< 1 - x
  double weight;
};

/// Double-exponential rule on (0, 1), x = 1/(1 + exp(-pi sinh s)), for integrands that are analytic inside and bounded
/// or logarithmic at the ends, times a polynomial of degree `degree` >= 0. `tolerance`, dimensionless, in (0, 1),
/// determines the step and the truncation; any other singularity of the integrand must be at least about a hundredth as
/// far from the interval as from the interval's nearer end. A polynomial of degree n grows at most like e^(2 n |Im s|)
/// in s; a smaller step makes up for this growth.
std::vector<UnitNode> double_exponential_rule(double tolerance, double degree = 0);

}  // namespace nipref::fast
