#pragma once
#include <array>
#include <complex>

#include <nipref/fast/number/two_words.hpp>

// The part of a kernel that fades on both sides of the load, D = I1, or I3, I4, I5 less (pi/4) sign, as its
// residue series: D(w) = Re sum_n C_n e^(i z_n |w|), with the sign of w for the odd ones. Memory of such a
// term is elementary.

namespace nipref::fast::internal {

enum class Kernel { I1, I3, I4, I5 };
inline constexpr int kernel_count = 4;

using Complex = std::complex<double>;

inline constexpr int most_waves = 16;
/// From here on most_waves residues are enough: the next is below e^(-pi 15) = 2^-67 of the first.
inline constexpr double nearest = 1;

/// The wave e^(i z_n |w|) for each n that matters at one |w| >= nearest.
struct Waves {
  int count = 0;
  std::array<double, most_waves> real, imaginary;

  [[nodiscard]] Complex value(int n) const {
    return {real[static_cast<std::size_t>(n)], imaginary[static_cast<std::size_t>(n)]};
  }
};

/// tolerance: relative to the first wave.
Waves waves(Two distance, double tolerance);

/// D at the waves' distance ahead of the load.
double faded_kernel(Kernel kernel, const Waves& at);

/// int_0^inf e^(-rate d) D(p + d) dd, p > 0 the waves' distance; Re rate >= 0. For complex rates too.
template <typename Rate>
Rate memory_from_far(Kernel kernel, const Waves& from, Rate rate);

/// int_0^length e^(-rate d) D(p + d) dd for a piece ahead of the load.
template <typename Rate>
Rate memory_of_piece_ahead(Kernel kernel, const Waves& from, Rate rate, double length);

/// int_0^length e^(-rate d) D(a - d) dd, D at positive arguments: a piece behind the load from the distance a
/// down to a - length >= nearest; `faded` is e^(-rate length).
template <typename Rate>
Rate memory_of_piece_behind(Kernel kernel, const Waves& from, const Waves& to, Rate rate, double length,
                            Rate faded);

/// sum Re C_n e^(i z_n a)/(rate + i z_n): the part of memory behind the load that its residues make up at a.
double residues_behind(Kernel kernel, const Waves& at, double rate);

}  // namespace nipref::fast::internal
