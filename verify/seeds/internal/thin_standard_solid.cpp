#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include <nipref/verify/seeds/internal/thin_standard_solid.hpp>

namespace nipref::verify {

ThinStandardSolid thin_standard_solid(double memory) {
  // By the way s from the leading end, in contact lengths: the stiffness forgets twice as fast as the compliance, so
  // that p is g(s) - (1/memory) int_0^s e^(-2 (s - r)/memory) g(r) dr of the parabola g = 2 share s - s^2.
  const double rate = 2 / memory;
  const auto of_line = [=](double s) { return s - (s + std::expm1(-rate * s) / rate) / (rate * memory); };
  const auto of_square = [=](double s) {
    const double line = (s + std::expm1(-rate * s) / rate) / rate;
    return s * s - (s * s - 2 * line) / (rate * memory);
  };
  const double share = of_square(1) / (2 * of_line(1));
  const auto pressure = [=](double s) { return 2 * share * of_line(s) - of_square(s); };
  using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
  const double load = Rule::integrate(pressure, 0.0, 1.0);
  const double moment = Rule::integrate([=](double s) { return pressure(s) * (share - s); }, 0.0, 1.0);
  return {share, moment / load};
}

}  // namespace nipref::verify
