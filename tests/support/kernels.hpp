#pragma once

// What the tests of fast's sheet kernels share: the kernels of one argument as a list, the scale their errors
// are measured by, and a plain residue sum in long double that takes nothing from the code under test.

#include <nipref/fast/sheet/kernels.hpp>

#include "support/test.hpp"

namespace fast_tests {

using nipref::fast::Accuracy;
using ComplexL = std::complex<long double>;

inline constexpr long double pi_long = std::numbers::pi_v<long double>;

/// sinh 2z + 2z = 0 by Newton from the asymptotic guess.
inline ComplexL root(int n) {
  const long double height = pi_long * (static_cast<long double>(n) - 0.25L);
  ComplexL z(std::log(4 * height) / 2, height);
  for (int step = 0; step < 8; ++step) {
    const ComplexL cosh_z = std::cosh(z);
    z -= (std::sinh(2.0L * z) + 2.0L * z) / (4.0L * cosh_z * cosh_z);
  }
  return z;
}

using Residue = ComplexL (*)(ComplexL);

/// limit + Re or -Im of 2 pi sum c(z_n) e^(i z_n x), for x > 0.
struct ResidueSum {
  Residue c;
  bool odd;

  [[nodiscard]] long double operator()(long double x) const {
    static const std::vector<ComplexL> roots = [] {
      std::vector<ComplexL> first;
      for (int n = 1; n <= 120; ++n) first.push_back(root(n));
      return first;
    }();
    ComplexL sum = 0;
    for (const ComplexL& z : roots) sum += c(z) * std::exp(ComplexL(0, 1) * z * x);
    return odd ? pi_long / 4 + 2 * pi_long * sum.real() : -2 * pi_long * sum.imag();
  }

  /// Size of the first residue without its cosine.
  [[nodiscard]] double envelope(double x) const {
    static const ComplexL z = root(1);
    return static_cast<double>(2 * pi_long * std::abs(c(z)) *
                               std::exp(-z.imag() * static_cast<long double>(x)));
  }
};

struct Kernel {
  std::string name;
  double (*scalar)(double, Accuracy);
  void (*batch)(std::span<const double>, std::span<double>, Accuracy);
  ResidueSum residues;
  bool infinite_at_zero;

  [[nodiscard]] double scale(double x, double value) const {
    const bool relative = residues.odd && std::fabs(x) < 0.5;
    return relative ? std::fabs(value) : std::max(std::fabs(value), residues.envelope(std::fabs(x)));
  }
};

namespace residue {
inline ComplexL I1(ComplexL z) { return std::tanh(z) * std::tanh(z) / (2.0L * z); }
inline ComplexL I3(ComplexL z) { return 0.5L / (std::cosh(z) * std::cosh(z)); }
inline ComplexL I4(ComplexL z) { return std::sinh(z) / (2.0L * z * std::cosh(z) * std::cosh(z)); }
inline ComplexL I5(ComplexL z) { return 0.5L / std::cosh(z); }
inline ComplexL I7(ComplexL z) { return std::sinh(z) / (2.0L * std::cosh(z) * std::cosh(z)); }
inline ComplexL alpha_part(ComplexL z) { return 0.5L / z; }
inline ComplexL eta_part(ComplexL z) { return 0.5L / (z * std::cosh(z)); }
}  // namespace residue

inline constexpr ResidueSum alpha_sum{residue::alpha_part, false};
inline constexpr ResidueSum eta_sum{residue::eta_part, false};

inline const std::vector<Kernel>& kernels() {
  using namespace nipref::fast;
  static const std::vector<Kernel> all = {
      {"I1", I1, I1, {residue::I1, false}, true},  {"I3", I3, I3, {residue::I3, true}, false},
      {"I4", I4, I4, {residue::I4, true}, false},  {"I5", I5, I5, {residue::I5, true}, false},
      {"I7", I7, I7, {residue::I7, false}, false},
  };
  return all;
}

inline double I6_scale(double alpha, double eta, double value) {
  return std::max(std::fabs(value), alpha_sum.envelope(std::fabs(alpha)) + eta_sum.envelope(std::fabs(eta)));
}

/// Unit in the last place of a number >= 0.
inline double ulp(double scale) { return std::ldexp(1.0, std::ilogb(std::max(scale, 0x1p-1022)) - 52); }

/// Log-uniform over [low, high].
inline std::vector<double> log_uniform(double low, double high, int count, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> exponent(std::log(low), std::log(high));
  std::vector<double> points;
  for (int i = 0; i < count; ++i) points.push_back(std::exp(exponent(generator)));
  return points;
}

}  // namespace fast_tests
