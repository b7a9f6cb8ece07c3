#pragma once
#include <complex>

namespace nipref::fast::internal {

/// 1/z without the library's treatment of infinities, which costs time.
inline std::complex<double> inverse(std::complex<double> z) {
  const double scale = 1 / (z.real() * z.real() + z.imag() * z.imag());
  return {z.real() * scale, -z.imag() * scale};
}

}  // namespace nipref::fast::internal
