#pragma once
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <limits>

namespace nipref::fast::internal {

/// The largest value of f(i) over 0 <= i <= samples: the best integer i, refined between its neighbours. If f there
/// is below `worth_refining`, it is not refined.
template <class Function>
double sampled_maximum(const Function& f, int samples,
                       double worth_refining = -std::numeric_limits<double>::infinity()) {
  int best = 0;
  for (int i = 1; i <= samples; ++i) {
    if (f(i) > f(best)) best = i;
  }
  if (f(best) < worth_refining) return f(best);
  const auto negative = [&](double i) { return -f(i); };
  const auto refined = boost::math::tools::brent_find_minima(negative, std::max(best - 1.0, 0.0),
                                                             std::min<double>(best + 1, samples), 30);
  return std::max(-refined.second, static_cast<double>(f(best)));
}

}  // namespace nipref::fast::internal
