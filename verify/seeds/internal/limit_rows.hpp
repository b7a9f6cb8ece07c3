#pragma once
#include <cmath>
#include <functional>

#include <nipref/verify/seeds/limits.hpp>

namespace nipref::verify {

std::vector<LimitRow> elastic_limits();
std::vector<LimitRow> rolling_limits();

/// Samples of sizes that fall by halves from `first` on.
inline std::vector<LimitSample> halved(double first, const std::function<LimitSample(double)>& sample_at) {
  constexpr int samples = 3;
  std::vector<LimitSample> all;
  for (int i = 0; i < samples; ++i) all.push_back(sample_at(std::ldexp(first, -i)));
  return all;
}

}  // namespace nipref::verify
