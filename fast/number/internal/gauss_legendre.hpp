#pragma once
#include <vector>

namespace nipref::fast {

/// Nodes and weights on [0, 1].
struct GaussRule {
  std::vector<double> at, weight;
};

/// That of Gauss and Legendre with `count` nodes, from extended precision: those next to 0 are right to their
/// own last place.
GaussRule gauss_legendre(const int& count);

}  // namespace nipref::fast
