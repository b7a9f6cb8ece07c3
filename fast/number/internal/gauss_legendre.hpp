#pragma once
#include <vector>

namespace nipref::fast {

/// Nodes and weights of a quadrature rule on [0, 1].
struct GaussRule {
  std::vector<double> at, weight;
};

/// The Gauss-Legendre rule with `count` nodes, computed in extended precision, so that nodes next to 0 are right to
/// their own last place.
GaussRule gauss_legendre(const int& count);

}  // namespace nipref::fast
