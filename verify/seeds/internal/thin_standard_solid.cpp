#include <nipref/verify/seeds/internal/numerics.hpp>
#include <nipref/verify/seeds/internal/thin_standard_solid.hpp>

namespace nipref::verify {

ThinStandardSolid thin_standard_solid(double memory) {
  // s is the distance from the leading end in contact lengths. The stiffness relaxes twice as fast as the compliance, so
  // that p is g(s) - (1/memory) int_0^s e^(-2 (s - r)/memory) g(r) dr of the parabola g = 2 share s - s^2.
  const Propagated rate = 2 / Propagated::exact(memory);
  const auto forgotten = [&](const Propagated& s) { return (s + expm1(-rate * s) / rate) / 2; };
  const auto of_line = [&](const Propagated& s) { return s - forgotten(s); };
  const auto of_square = [&](const Propagated& s) { return s * s / 2 + 2 * forgotten(s) / rate; };
  const Propagated one = Propagated::exact(1), share = of_square(one) / (2 * of_line(one));
  const auto pressure = [&](const Propagated& s) { return 2 * share * of_line(s) - of_square(s); };
  const auto integral_of = [](const auto& f) {
    return smooth_integral([&](double s) { return f(Propagated::exact(s)); }, 0.0, 1.0);
  };
  const Propagated load = integral_of(pressure);
  const Propagated moment = integral_of([&](const Propagated& s) { return pressure(s) * (share - s); });
  return {share, moment / load};
}

}  // namespace nipref::verify
