#pragma once

// For the tests of fast's sheet kernels: a list of the kernels of one argument, and the scales by which their errors
// are measured.

#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>

#include "support/test.hpp"

namespace fast_tests {

using nipref::fast::Accuracy;

struct Kernel {
  std::string name;
  double (*scalar)(double, Accuracy);
  void (*batch)(std::span<const double>, std::span<double>, Accuracy);
  bool odd, infinite_at_zero;
  const nipref::verify::Quantity& quantity = nipref::verify::find_quantity(name);

  [[nodiscard]] double scale(double x, double value) const {
    return std::max(std::fabs(value), quantity.envelope(std::array{x}));
  }
};

inline const std::vector<Kernel>& kernels() {
  using namespace nipref::fast;
  static const std::vector<Kernel> all = {{"I1", I1, I1, false, true},
                                          {"I3", I3, I3, true, false},
                                          {"I4", I4, I4, true, false},
                                          {"I5", I5, I5, true, false},
                                          {"I7", I7, I7, false, false}};
  return all;
}

/// The unit in the last place of a number >= 0.
inline double ulp(double scale) { return std::ldexp(1.0, std::ilogb(std::max(scale, 0x1p-1022)) - 52); }

/// Log-uniform random numbers from [low, high].
inline std::vector<double> log_uniform(double low, double high, int count, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> exponent(std::log(low), std::log(high));
  std::vector<double> points;
  for (int i = 0; i < count; ++i) points.push_back(std::exp(exponent(generator)));
  return points;
}

}  // namespace fast_tests
