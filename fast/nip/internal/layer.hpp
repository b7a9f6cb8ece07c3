#pragma once
#include <complex>

namespace nipref::fast {

/// Dawson's integral D(z) = z int_0^1 e^(-z^2 (1 - t^2)) dt, as a function of z^2, Re z^2 >= 0.
std::complex<double> dawson_of_square(std::complex<double> square);

/// The pressure -(2 rate/sqrt pi) D(sqrt(rate e)) over e > 0, whose displacement by the kernel -ln|e - e'|/pi is e^(-rate e)
/// and a constant: that of H[D] = -(sqrt pi/2) e^(-x^2), H the Hilbert transform.
std::complex<double> layer_pressure(std::complex<double> rate, double e);

}  // namespace nipref::fast
