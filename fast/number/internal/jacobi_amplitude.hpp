#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace nipref::fast {

/// Jacobi's elliptic functions of modulus k, computed from the complementary modulus k', k^2 + k'^2 = 1, 0 < k' <= 1,
/// as k' loses no digits for k -> 1.
class JacobiAmplitude {
 public:
  struct Values {
    double sn, cn, dn;
  };

  /// Computes K(k) by the arithmetic-geometric mean, and the moduli of Landen's descending transformation from k'.
  explicit JacobiAmplitude(double complementary_modulus) : complement_(complementary_modulus) {
    double mean = 1, geometric = complement_;
    while (mean - geometric > 1e-12 * mean) {
      const double next = (mean + geometric) / 2;
      geometric = std::sqrt(mean * geometric);
      mean = next;
    }
    quarter_ = std::numbers::pi / (mean + geometric);
    for (double modulus = complement_; modulus < 1 && levels_ < moduli_.size();) {
      modulus = std::pow(modulus / (1 + std::sqrt((1 - modulus) * (1 + modulus))), 2);
      if (modulus < 1e-17 * complement_) break;  // sc^2 grows up to 1/k'
      moduli_[levels_++] = modulus;
    }
  }

  /// K(k), the quarter period.
  [[nodiscard]] double quarter_period() const { return quarter_; }

  /// The functions at u, 0 <= u <= K/2, each to a few units in its last place, even cn, which may be as small as
  /// sqrt(k'). They come from Landen's descending transformation of sn on the imaginary axis, sc(u, k) = -i sn(iu, k').
  [[nodiscard]] Values operator()(double u) const {
    if (complement_ == 1) return {std::sin(u), std::cos(u), 1};
    double argument = u;
    for (std::size_t level = 0; level < levels_; ++level) argument /= 1 + moduli_[level];
    double sc = std::sinh(argument);
    for (std::size_t level = levels_; level-- > 0;)
      sc = (1 + moduli_[level]) * sc / (1 - moduli_[level] * sc * sc);
    const double secant = std::sqrt(1 + sc * sc), scaled = complement_ * sc;
    return {sc / secant, 1 / secant, std::sqrt(1 + scaled * scaled) / secant};
  }

 private:
  double complement_, quarter_ = 0;
  std::array<double, 16> moduli_{};
  std::size_t levels_ = 0;
};

}  // namespace nipref::fast
