#pragma once
#include <array>
#include <span>

#include <nipref/fast/memory/internal/waves.hpp>

namespace nipref::fast::internal {

/// Rates from which on SmoothMemory is used.
inline constexpr double polynomial_from = 100;

/// The coefficients c of f(w) = c_0/2 + sum_k c_k T_k(w/1.25), a polynomial on [-1, 1] and somewhat beyond.
template <typename Coefficient>
class Series {
 public:
  static constexpr std::size_t most_terms = 36;
  static constexpr double half_width = 1.25;

  /// As many of them as are left when the last, whose sizes add up to less than `negligible`, are gone.
  Series(const std::array<Coefficient, most_terms>& coefficients, double negligible);
  [[nodiscard]] Coefficient operator()(double w) const;
  [[nodiscard]] const std::array<Coefficient, most_terms>& coefficients() const { return coefficients_; }
  [[nodiscard]] std::size_t terms() const { return terms_; }

 private:
  std::array<Coefficient, most_terms> coefficients_;
  std::size_t terms_ = most_terms;
};

/// The part of Kernel::I1 or Kernel::I3 that is analytic but for |Im w| >= 2: I1(w) + ln |w|, or I3(w).
const Series<double>& smooth_part(Kernel kernel);
const Series<double>& slope_of_smooth_part(Kernel kernel);

/// int_0^(1 - w) e^(-rate x) f(w + x) dx for a series f and |w| <= 1. It is P(w) - e^(-rate (1 - w)) P(1), P the polynomial
/// with rate P - P' = f, which is the sum of f's derivatives of order n over rate^(n + 1). A derivative of T_k(w/1.25) is at
/// most k/sqrt(1.25^2 - w^2) <= 48 times as large as T_k, so that the rounding of f's coefficients grows less than twofold
/// from polynomial_from on.
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
