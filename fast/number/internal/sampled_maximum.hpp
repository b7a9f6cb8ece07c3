#pragma once
#include <algorithm>
#include <boost/math/tools/minima.hpp>

namespace nipref::fast::internal {

/// Where f(i) is largest over 0 <= i <= samples: the best integer i, refined between its neighbours.
template <class Function>
double place_of_sampled_maximum(const Function& f, int samples) {
  int best = 0;
  double largest = f(0);
  for (int i = 1; i <= samples; ++i) {
    const double here = f(i);
    if (here > largest) {
      largest = here;
      best = i;
    }
  }
  const auto negative = [&](double i) { return -f(i); };
  const auto [place, value] = boost::math::tools::brent_find_minima(negative, std::max(best - 1.0, 0.0),
                                                                    std::min<double>(best + 1, samples), 30);
  return -value > largest ? place : best;
}

}  // namespace nipref::fast::internal
