#pragma once
#include <array>
#include <complex>

#include <nipref/fast/number/two_words.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

// The decaying part D of a kernel is I1 itself, or I3, I4 or I5 minus (pi/4) sign(w). Its residue series is
// D(w) = Re sum_n C_n e^(i z_n |w|), times the sign of w for the odd kernels. A wave is a term of this series; its
// integrals with an exponential are elementary.

namespace nipref::fast::internal {

enum class Kernel { I1, I3, I4, I5 };  ///< numbered like Component, see tables.hpp
inline constexpr int kernel_count = 4;

using Complex = std::complex<double>;

inline constexpr int most_waves = tabulated_roots;
/// From this distance on most_waves waves are enough: the next wave is below e^(-pi 15) = 2^-67 of the first.
inline constexpr double nearest = 1;

/// The waves e^(i z_n |w|) at one |w| >= nearest, as many as the tolerance needs.
struct Waves {
  int count = 0;
  std::array<double, most_waves> real, imaginary;

  [[nodiscard]] Complex value(int n) const {
    return {real[static_cast<std::size_t>(n)], imaginary[static_cast<std::size_t>(n)]};
  }
};

/// `tolerance` is relative to the first wave.
Waves waves(Two distance, double tolerance);

/// D at the waves' distance ahead of the load.
double faded_kernel(Kernel kernel, const Waves& at);

enum class Side { ahead, behind };

/// The sum Re C_n (i z_n)^order e^(i z_n w)/(rate -+ i z_n), where w > 0 is the distance of the waves, the rate is real
/// or complex with Re rate >= 0, and the order of the derivative D^(order) is 0 or 1. Side::ahead takes the minus,
/// which gives int_0^inf e^(-rate d) D^(order)(w + d) dd. Side::behind takes the plus, which gives the antiderivative
/// of e^(-rate d) D^(order)(w - d).
template <typename Rate>
Rate memory_of_waves(Kernel kernel, const Waves& at, Rate rate, Side side, int order = 0);

/// int_0^length e^(-rate d) D(p + d) dd for a piece ahead of the load.
template <typename Rate>
Rate memory_of_piece_ahead(Kernel kernel, const Waves& from, Rate rate, double length);

/// int_0^length e^(-rate d) D(a - d) dd for a piece behind the load, from the distance a to a - length >= nearest.
/// `faded` must be e^(-rate length).
template <typename Rate>
Rate memory_of_piece_behind(Kernel kernel, const Waves& from, const Waves& to, Rate rate, double length,
                            Rate faded);

}  // namespace nipref::fast::internal
