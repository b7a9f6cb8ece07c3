#pragma once
#include <nipref/ref/number/internal/complex_float.hpp>

namespace nipref::ref {

/// e^{-z} Ei(z) to the working precision, relative to 1/|z| or to itself, whatever is more; z not 0. Ei(z) =
/// gamma + ln z + sum z^k/(k k!) where Re z > 0, ln(-z) for ln z where Re z < 0: the exponential integral of
/// real z, continued from either half-line to its half-plane.
ComplexFloat scaled_exponential_integral(const ComplexFloat& z);

/// int_0^inf e^{-rate w} ln|x - w| dw = (ln|x| - e^{-rate x} Ei(rate x))/rate, x not 0, Re rate > 0: for real
/// rates by parts, a principal value; both sides are analytic in the rate. Of rate 0 the integral of ln|x| up to x
/// but for a constant, x ln|x| - x: like the others one of the functions f with f' + rate f = ln|x|.
ComplexFloat fading_logarithm(const ComplexFloat& rate, const Float& x);

}  // namespace nipref::ref
