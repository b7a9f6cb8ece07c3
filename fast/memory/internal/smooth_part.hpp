#pragma once
#include <vector>

#include <nipref/fast/memory/internal/waves.hpp>

namespace nipref::fast::internal {

/// SmoothMemory is used for complex rates whose modulus is at least this.
inline constexpr double polynomial_from = 100;

/// The coefficients c of f(w) = c_0/2 + sum_k c_k T_k(w/1.25), a polynomial on [-1, 1] and somewhat beyond.
template <typename Coefficient>
class Series {
 public:
  static constexpr double half_width = 1.25;

  /// Drops the last coefficients as long as the sum of their magnitudes is at most `negligible`.
  Series(std::vector<Coefficient> coefficients, double negligible);
  [[nodiscard]] Coefficient operator()(double w) const;
  /// Coefficient c_k, which is 0 beyond the last one.
  [[nodiscard]] Coefficient coefficient(std::size_t k) const {
    return k < coefficients_.size() ? coefficients_[k] : Coefficient(0);
  }
  [[nodiscard]] std::size_t terms() const { return coefficients_.size(); }

 private:
  std::vector<Coefficient> coefficients_;
};

/// The smooth part of Kernel::I1 or Kernel::I3, which is analytic for |Im w| < 2: I1(w) + ln |w|, or I3(w).
const Series<double>& smooth_part(Kernel kernel);
const Series<double>& slope_of_smooth_part(Kernel kernel);

/// int_0^(1 - w) e^(-rate x) f(w + x) dx for a series f and |w| <= 1. It is P(w) - e^(-rate (1 - w)) P(1), where P is
/// the polynomial with rate P - P' = f. For rates of modulus polynomial_from or more, P is the sum over n of
/// f^(n)/rate^(n + 1). A derivative of T_k(w/1.25) is at most k/sqrt(1.25^2 - w^2) <= 48 times as large as T_k, so that
/// the rounding error of f's coefficients less than doubles. For smaller rates, which are real, P is the integral up to
/// w = 1.25. With P'_(k-1) - P'_(k+1) = 2 k P_k its coefficients satisfy, r = 1.25 rate,
///     r (P_(k-1) - P_(k+1)) - 2 k P_k = 1.25 (f_(k-1) - f_(k+1)),  P(1.25) = 0.
/// From the last coefficient down, P_k = a_k + b_k P_(k-1) with 0 < b_k = r/(2 k + r b_(k+1)), where nothing cancels.
template <typename Rate>
class SmoothMemory {
 public:
  SmoothMemory(const Series<double>& f, Rate rate);
  [[nodiscard]] Rate from(double w) const;

 private:
  Rate rate_;
  Series<Rate> polynomial_;
  Rate at_nearest_;
};

}  // namespace nipref::fast::internal
