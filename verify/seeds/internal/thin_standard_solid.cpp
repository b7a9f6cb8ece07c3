#include <nipref/verify/seeds/internal/numerics.hpp>
#include <nipref/verify/seeds/internal/thin_standard_solid.hpp>

namespace nipref::verify {

ThinStandardSolid thin_standard_solid(double memory) {
  // By the way s from the leading end, in contact lengths: the stiffness forgets twice as fast as the compliance, so
  // that p is g(s) - (1/memory) int_0^s e^(-2 (s - r)/memory) g(r) dr of the parabola g = 2 share s - s^2.
  const WithError rate = 2 / WithError::exact(memory);
  const auto forgotten = [&](const WithError& s) { return (s + expm1(-rate * s) / rate) / 2; };
  const auto of_line = [&](const WithError& s) { return s - forgotten(s); };
  const auto of_square = [&](const WithError& s) { return s * s / 2 + 2 * forgotten(s) / rate; };
  const WithError one = WithError::exact(1), share = of_square(one) / (2 * of_line(one));
  const auto pressure = [&](const WithError& s) { return 2 * share * of_line(s) - of_square(s); };
  const WithError load = smooth_integral(pressure, 0.0, 1.0);
  const WithError moment =
      smooth_integral([&](const WithError& s) { return pressure(s) * (share - s); }, 0.0, 1.0);
  return {share, moment / load};
}

}  // namespace nipref::verify
