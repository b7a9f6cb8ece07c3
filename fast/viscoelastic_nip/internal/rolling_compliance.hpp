#pragma once
#include <array>
#include <compare>
#include <complex>
#include <vector>

namespace nipref::fast {

/// amplitude e^(-rate x): a memory over the distance x that the material has moved, half-thicknesses.
struct Memory {
  std::complex<double> amplitude, rate;

  /// An arbitrary order, for caches.
  friend auto operator<=>(const Memory& a, const Memory& b) {
    const auto parts = [](const Memory& one) {
      return std::array{one.amplitude.real(), one.amplitude.imag(), one.rate.real(), one.rate.imag()};
    };
    return parts(a) <=> parts(b);
  }
};

/// The compliance of a rolling sheet over its instantaneous part, and its inverse. With D = d/dx along the path of the
/// material their transforms are N = 1 + sum n_k/(D + s_k) and 1/N = 1 + sum m_j/(D + r_j).
struct RollingCompliance {
  std::vector<Memory> terms;  ///< n_k, s_k; conjugate pairs complete
  /// m_j, r_j in order of falling |r_j|; of each pair the rate with Im > 0 first. The zeros of N are -r_j.
  std::vector<Memory> inverse;
  /// 1 + m_1/r_1 + .. + m_j/r_j for j = 0, 1, .., right to the last digit. The last is 1/N(0), the stiffness at rest.
  std::vector<double> stiffness;
  /// m_j n_k/(r_j - s_k), a row for each j, accurate even if r_j is close to s_k.
  std::vector<std::vector<std::complex<double>>> closure;
};

/// Cached, because sweeps and searches need one sheet many times.
RollingCompliance rolling_compliance(const std::vector<Memory>& terms);

}  // namespace nipref::fast
