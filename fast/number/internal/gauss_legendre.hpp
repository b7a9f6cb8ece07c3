#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace nipref::fast {

/// Nodes and weights on [0, 1].
struct GaussRule {
  std::vector<double> at, weight;
};

/// That of Gauss and Legendre with `count` nodes, from extended precision: those next to 0 are right to their
/// own last place.
GaussRule gauss_legendre(const int& count);

/// P_0 .. P_(count-1) at t.
inline void legendre(double t, std::span<double> values) {
  values[0] = 1;
  values[1] = t;
  for (std::size_t k = 2; k < values.size(); ++k) {
    const auto n = static_cast<double>(k);
    values[k] = ((2 * n - 1) * t * values[k - 1] - (n - 1) * values[k - 2]) / n;
  }
}

}  // namespace nipref::fast
