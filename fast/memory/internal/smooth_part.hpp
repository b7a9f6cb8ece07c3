#pragma once
#include <array>
#include <span>

#include <nipref/fast/memory/internal/waves.hpp>

namespace nipref::fast::internal {

/// Rates from which on memories are integrated by parts.
inline constexpr double by_parts_from = 400;

/// The part of a kernel that is analytic but for |Im w| >= 2: I1(w) + ln |w|, or I3(w). With its derivatives on [-1, 1],
/// which are those of a polynomial through Chebyshev points. The derivative of order n is as exact as its part in a series in
/// 1/rate needs from rate = by_parts_from on, where it is divided by rate^(n - 1).
class SmoothPart {
 public:
  static constexpr int derivatives = 7;

  /// Kernel::I1 or Kernel::I3.
  static const SmoothPart& of(Kernel kernel);
  /// The derivative of that order, from 0 on.
  [[nodiscard]] double operator()(int order, double w) const;
  /// At many places at once, which a processor works off side by side.
  void at(int order, std::span<const double> w, std::span<double> values) const;

 private:
  explicit SmoothPart(Kernel kernel);
  void count();

  static constexpr std::size_t points = 36;  ///< even, so that none is at 0
  static constexpr double half = 1.25;
  std::array<std::array<double, points + 1>, derivatives + 1> coefficients_{};
  std::array<std::size_t, derivatives + 1> counts_{};  ///< of coefficients that count
};

/// int_0^(1 - w) e^(-rate x) f(w + x) dx, f the smooth part from its derivative of order `first` on, by parts: for rates
/// above by_parts_from. Their k-th term is about k!/(2 rate)^k of the whole, 2e-17 of it where they end.
Complex smooth_memory_by_parts(Kernel kernel, int first, double w, Complex rate);

}  // namespace nipref::fast::internal
