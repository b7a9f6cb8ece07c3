#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace nipref::fast {

/// Jacobi's elliptic functions for the complementary modulus k' (0 < k' <= 1), k^2 + k'^2 = 1, by the
/// arithmetic-geometric mean, which takes k' itself and so keeps its digits for k -> 1.
class JacobiAmplitude {
 public:
  struct Values {
    double sn, cn, dn;
  };

  explicit JacobiAmplitude(double complementary_modulus) : complement_(complementary_modulus) {
    double mean = 1, geometric = complement_;
    // Each level left out would move the amplitude by half the difference.
    while (std::fabs(mean - geometric) > 1e-16 * mean && levels_ < ratios_.size()) {
      const double next = (mean + geometric) / 2;
      ratios_[levels_++] = (mean - geometric) / (2 * next);
      geometric = std::sqrt(mean * geometric);
      mean = next;
    }
    mean_ = mean;
  }

  /// K(k), the quarter period.
  [[nodiscard]] double quarter_period() const { return std::numbers::pi / (2 * mean_); }

  /// 0 <= u <= K/2, where all three are far from their zeros but sn at 0: to a few ulp, cn to eps/sqrt(k').
  [[nodiscard]] Values operator()(double u) const {
    double amplitude = std::ldexp(mean_ * u, static_cast<int>(levels_));
    for (std::size_t level = levels_; level-- > 0;)
      amplitude = (amplitude + std::asin(ratios_[level] * std::sin(amplitude))) / 2;
    const double sn = std::sin(amplitude), cn = std::cos(amplitude);
    return {sn, cn, std::hypot(cn, complement_ * sn)};
  }

 private:
  double complement_, mean_ = 1;
  std::array<double, 16> ratios_{};
  std::size_t levels_ = 0;
};

}  // namespace nipref::fast
