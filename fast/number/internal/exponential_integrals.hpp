#pragma once
#include <complex>

namespace nipref::fast::internal {

// Functions for the integrals of a logarithm times an exponential, scaled so that nothing overflows or cancels, for
// x >= 0. Their relative errors are a few units in the last place, unless said otherwise.

/// e^-z; returns 0 at once where e^-z underflows, as std::exp is slow there.
template <class Number>
Number faded_exp(Number z) {
  constexpr double underflows = 746;
  return std::real(z) > underflows ? Number(0) : std::exp(-z);
}

/// 1/z for finite z. It is faster than the standard library's division, which also treats infinities.
inline std::complex<double> inverse(std::complex<double> z) {
  const double scale = 1 / (z.real() * z.real() + z.imag() * z.imag());
  return {z.real() * scale, -z.imag() * scale};
}

/// (1 - e^-x)/x, 1 at 0.
double phi1(double x);

/// (1 - e^-z)/z for any complex z, to a few units in the last place of its modulus; it overflows where e^-z does.
std::complex<double> phi1(std::complex<double> z);

/// Ein(x)/x = (1/x) int_0^x (1 - e^-t)/t dt, 1 at 0.
double ein_ratio(double x);

/// e^-x (1/x) int_0^x (e^t - 1)/t dt, 1 at 0.
double faded_ein_ratio(double x);

/// e^x E1(x), x > 0. For complex z, Re z >= 0, the error is a few dozen units in the last place.
double scaled_E1(double x);
std::complex<double> scaled_E1(std::complex<double> z);

/// e^-z Ei(z), Re z >= 0, where Ei(z) = gamma + ln z + sum z^k/(k k!). The error is a few dozen units in the last place.
std::complex<double> scaled_Ei(std::complex<double> z);

}  // namespace nipref::fast::internal
