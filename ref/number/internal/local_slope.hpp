#pragma once
#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// f'(x) of a function that is analytic at least within four times `reach` of x, from the polynomial through Chebyshev
/// points within `reach`. The rounding errors of f are divided by `reach`; no other digits of the working precision are
/// lost.
template <class Function>
Float local_slope(const Function& f, const Float& x, const Float& reach) {
  // The interpolation error is about (4 + sqrt 15)^-nodes.
  const int pairs = static_cast<int>(working_bits()) / 5 + 4, nodes = 2 * pairs;
  Float sum = 0;
  for (int j = 0; j < pairs; ++j) {
    // sum_k a_k T_k'(0) over odd k, a_k = (2/nodes) sum_j f_j cos(k theta_j), T_k'(0) = k sin(k pi/2).
    const Float theta = (2 * j + 1) * pi() / (2 * nodes), place = cos(theta);
    Float weight = 0, before = place, now = place;  // cos(-theta), cos(theta)
    const Float twice = 2 * cos(2 * theta);
    for (int k = 1; k < nodes; k += 2) {
      weight += (k % 4 == 1 ? k : -k) * now;
      Float next = twice * now - before;
      before = std::move(now);
      now = std::move(next);
    }
    sum += weight * (f(x + reach * place) - f(x - reach * place));
  }
  return 2 * sum / (nodes * reach);
}

}  // namespace nipref::ref
