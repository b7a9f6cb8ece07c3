#pragma once
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/internal/complex_interval.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>

namespace nipref::ref {

/// steady_memory() of fading.hpp for a real or complex rate L, Re L > 0, which is given as an interval; |alpha| <=
/// 1000. The half-width is about e^{-nats} plus the effect of the rate's interval. Proven.
///
/// With A = |alpha|, c = 1/2 for I1 and 1/(2i) for odd kernels, and the integral
///
///     U(A, m) = c int G(z) e^{i z A}/(m - i z) dz    along z(t) = sinh(t + i phi)
///
/// it is, as in fading.hpp for real rates,
///
///     alpha >= 0    U(A, L)               + pi/(4 L) for odd kernels
///     alpha < 0     +-U(A, -L) + P        - pi/(4 L) for odd kernels; - for I1
///
/// with P = pi G(i L) e^{-L A}, times i for odd kernels, which is left out where the pole i L is above the path. The
/// trapezoidal rule with step h uses the strip phi +- 3/16, phi = 1/4 or 3/4, whichever is at least 1/16 from the pole.
/// The errors
///
///     aliasing      104 * 30/(e^{2 pi (3/16)/h} - 1);   2 pi (3/16)/h >= nats + 10
///     truncation    104 * 6/0.7 e^{-q(J h)}, q(t) = k t + r Re z + A Im z as for real rates;   q(J h) >= nats + 9,
///                   Re z(J h) >= 2
///
/// are below e^{-nats}/2. Everything else is interval arithmetic. Proof: ref/memory/README.md, Complex rates.
ComplexInterval oscillating_memory(Symbol kernel, const Exact& alpha, const ComplexInterval& rate,
                                   double nats);

}  // namespace nipref::ref
