#pragma once
#include <vector>

#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// Nodes and weights on 0 .. 1, to the working precision.
struct UnitRule {
  std::vector<Float> from_left;   ///< of a node to 0
  std::vector<Float> from_right;  ///< of a node to 1, exact where nodes crowd there
  std::vector<Float> weight;

  [[nodiscard]] std::size_t size() const { return weight.size(); }
};

/// Gauss-Legendre: exact for polynomials of degree 2 points - 1.
UnitRule gauss_rule(int points);

/// Double exponential, 1/(1 + e^{-pi sinh t}) in steps of t: for ends where the integrand is singular like a
/// logarithm or a square root and otherwise analytic, times a polynomial of the given degree, to about
/// e^{-nats}. (Takahasi and Mori 1974)
UnitRule double_exponential_rule(double nats, int degree);

}  // namespace nipref::ref
