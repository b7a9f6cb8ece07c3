#pragma once
#include <vector>

#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// The nodes and weights of a quadrature rule on (0, 1), to the working precision.
struct UnitRule {
  std::vector<Float> from_left;   ///< distance of a node from 0
  std::vector<Float> from_right;  ///< distance of a node from 1, exact where nodes crowd there
  std::vector<Float> weight;

  [[nodiscard]] std::size_t size() const { return weight.size(); }
};

/// The rule of Gauss and Legendre, which is exact for polynomials of degree 2 points - 1.
UnitRule gauss_rule(int points);

/// The double exponential rule, with nodes 1/(1 + e^{-pi sinh t}) at equidistant t and an error of about e^{-nats}. The
/// integrand is a polynomial of the given degree times an analytic function that may be singular like a logarithm or a
/// square root at the ends. (Takahasi and Mori 1974)
UnitRule double_exponential_rule(double nats, int degree);

}  // namespace nipref::ref
