#pragma once
#include <array>
#include <complex>

#include <nipref/fast/number/two_words.hpp>

// The decaying part D of a kernel, which is I1 itself, or I3, I4, I5 less (pi/4) sign(w), as its residue series
// D(w) = Re sum_n C_n e^(i z_n |w|), times the sign of w for the odd kernels. A term of the series is called a wave;
// its integrals with an exponential are elementary.

namespace nipref::fast::internal {

enum class Kernel { I1, I3, I4, I5 };
inline constexpr int kernel_count = 4;

using Complex = std::complex<double>;

inline constexpr int most_waves = 16;
/// From this distance on most_waves waves are enough: the next is below e^(-pi 15) = 2^-67 of the first.
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

/// int_0^inf e^(-rate d) D(p + d) dd, where p > 0 is the waves' distance. The rate is real or complex, Re rate >= 0.
template <typename Rate>
Rate memory_from_far(Kernel kernel, const Waves& from, Rate rate);

/// The same integral of the kernel's derivative D'.
template <typename Rate>
Rate slope_memory_from_far(Kernel kernel, const Waves& from, Rate rate);

/// The antiderivative of e^(-rate d) D'(a - d) at the distance a behind the load, of an odd kernel, whose derivative is even.
template <typename Rate>
Rate slope_residues_behind(Kernel kernel, const Waves& at, Rate rate);

/// int_0^length e^(-rate d) D(p + d) dd for a piece ahead of the load.
template <typename Rate>
Rate memory_of_piece_ahead(Kernel kernel, const Waves& from, Rate rate, double length);

/// int_0^length e^(-rate d) D(a - d) dd for a piece behind the load, from the distance a to a - length >= nearest.
/// `faded` is e^(-rate length).
template <typename Rate>
Rate memory_of_piece_behind(Kernel kernel, const Waves& from, const Waves& to, Rate rate, double length,
                            Rate faded);

/// sum Re C_n e^(i z_n a)/(rate + i z_n), the residues' part of the memory at the distance a behind the load.
double residues_behind(Kernel kernel, const Waves& at, double rate);

}  // namespace nipref::fast::internal
