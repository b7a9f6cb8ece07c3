#pragma once
#include <array>
#include <compare>
#include <complex>
#include <vector>

namespace nipref::fast {

/// amplitude e^(-rate x): a memory over the distance x that the material has moved, half-thicknesses.
struct Memory {
  std::complex<double> amplitude, rate;

  /// Any order, for caches.
  friend auto operator<=>(const Memory& a, const Memory& b) {
    const auto parts = [](const Memory& one) {
      return std::array{one.amplitude.real(), one.amplitude.imag(), one.rate.real(), one.rate.imag()};
    };
    return parts(a) <=> parts(b);
  }
};

/// The compliance of a rolling sheet in units of what gives way at once, and its inverse: with D = d/dx along the
/// material's path their transforms are N = 1 + sum n_k/(D + s_k) and 1/N = 1 + sum m_j/(D + r_j).
struct RollingCompliance {
  std::vector<Memory> terms;  ///< n_k, s_k; conjugate pairs complete
  /// m_j, r_j, the zeros of N, in order of falling |r_j|; of each pair that with Im rate > 0 first.
  std::vector<Memory> inverse;
  /// 1 + m_1/r_1 + .. + m_j/r_j for j = 0, 1, .., right to its last digit. The last one is 1/N(0), the stiffness at rest.
  std::vector<double> stiffness;
  /// m_j n_k/(r_j - s_k), a row for each j. r_j may be next to s_k.
  std::vector<std::vector<std::complex<double>>> closure;
};

/// Cached: sweeps and searches ask for one sheet many times.
RollingCompliance rolling_compliance(const std::vector<Memory>& terms);

}  // namespace nipref::fast
