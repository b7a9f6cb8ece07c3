#include <nipref/ref/half_space/sliding.hpp>

#include "support/isotropic_surface.hpp"
#include "support/test.hpp"

using namespace nipref;
using ref::Exact;

TEST_CASE("the reference's sliding force next to the critical speed is that of the closed form") {
  // K = 1/(1 - c cos^2), no friction: F/(C L^3) = (1/12) int K^2 dpsi/K(0)^3 = (pi/12) (1 - c)^(3/2) (1 - c/2).
  for (const double gap : {1e-3, 2e-6, 1e-9}) {
    const ref::SurfaceAnswer peaked = [gap](const Exact& degrees, int digits) -> ref::LineAnswer {
      const ref::WorkingDigits working(digits + 20);
      const ref::Float s = sin(ref::to_float(degrees) * ref::pi() / 180), none = 0;
      const ref::Float compliance = 1 / (gap + (1 - ref::Float(gap)) * s * s);
      return {compliance, none, none, none};
    };
    CHECK(ref::sliding_force(peaked, Exact(0.0), 20).to_double() ==
          approx(std::numbers::pi / 12 * std::pow(gap, 1.5) * (1 + gap) / 2, 1e-14));
  }
}

TEST_CASE("the reference's sliding exponent is right where friction outweighs the compliance") {
  // At rest K = 1 - nu and S = (1 - 2 nu)/2: next to the line across, h meets K within an angle of K/(friction S).
  const auto surface = isotropic_surface(0.25, 1e-30);
  CHECK(ref::sliding_exponent(surface, Exact(1000.0), Exact(0.0), 20).to_double() ==
        doctest::Approx(-std::atan(0.75 / 250) / std::numbers::pi).epsilon(1e-15));
  CHECK(ref::sliding_exponent(surface, Exact(1000.0), Exact(90.0), 20).to_double() == -0.5);
  CHECK_NOTHROW((void)ref::sliding_force(surface, Exact(700.0), 16));
  CHECK_THROWS_AS((void)ref::sliding_force(surface, Exact(0.5), 15), data::BadInput);
  CHECK_REFUSED(ref::sliding_force(surface, Exact(1001.0), 16), "must be from 0 to 1000");
}
