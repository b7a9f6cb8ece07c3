#pragma once
#include <vector>

#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// The nodes and weights of a quadrature rule on (0, 1), to the working precision.
struct UnitRule {
  std::vector<Float> from_left;  ///< distance of a node from 0
  std::vector<Float> weight;

  [[nodiscard]] std::size_t size() const { return weight.size(); }
};

/// The rule of Gauss and Legendre, which is exact for polynomials of degree 2 points - 1.
UnitRule gauss_rule(int points);

/// A point 1/(1 + e^{-pi sinh t}) of the double exponential rule on (0, 1), which is the trapezoidal rule in t: the distances
/// from 0 and 1, each exact where points crowd there, and the derivative by t. (Takahasi and Mori 1974)
struct UnitPoint {
  Float from_left, from_right, slope;

  explicit UnitPoint(const Float& t);
};

}  // namespace nipref::ref
