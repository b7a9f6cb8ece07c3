// What fast promises of half-spaces holds against the arguments as they are given, to the ends of the domain:
// angles in degrees, constants in GPa, speeds next to the critical one.
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/deviation.hpp>

#include "support/test.hpp"

using namespace nipref;
using verify::Point;
using verify::Quantity;

namespace {

void check_kept(const char* name, const Point& point) {
  CAPTURE(name);
  const Quantity& quantity = verify::find_quantity(name);
  const std::vector<ref::Exact> exactly(point.begin(), point.end());
  const ref::Estimate truth = quantity.by_ref(exactly, verify::digits_beyond_double);
  const double value = quantity.by_fast(point, {});
  CHECK(verify::deviation(value, truth, quantity.envelope(point)).ulps <= quantity.promise);
}

constexpr double in_plane = 1;

double fast_at(const char* name, const Point& point) {
  return verify::find_quantity(name).by_fast(point, {});
}

}  // namespace

TEST_CASE("half-spaces in degrees, GPa and speeds of steel: what once was beyond the promise") {
  check_kept("halfspace.coupling", {0x1.fffff94a03595p-2, 0x1.e91e97e2fdb23p-1, 45});
  check_kept("rolling.index", {0x1.3333333333333p-2, 0x1.dad5d6ac2bda0p-1, 0});
  // Thousands of panels chased the rounding of a moment that is nearly 0.
  check_kept("die.force", {0x1.ffffff543388fp-2, 0x1p-1074, 0x1.fffffffffffffp-1});
  for (const char* name : {"ti.compliance", "ti.coupling", "ti.coupling_across"})
    check_kept(name, {0, 135, 0x1.bcb952498e366p-3, in_plane, 10, 10, 0x1.2cccccccccccdp+3, 9, 1, 1000});
}

TEST_CASE("half-spaces next to the critical speed: the promises hold on critical lines") {
  // Of the seed's solid, moving at 45 degrees from the axis; its critical line is 20 degrees off.
  const verify::Quantity& critical = verify::find_quantity("ti.critical");
  const Point epoxy{in_plane, 13.9, 160.7, 6.44, 7.07, 3.5, 1688};
  Point motion{45};
  motion.insert(motion.end(), epoxy.begin(), epoxy.end());
  const double limit = critical.by_fast(motion, {});
  for (const double gap : {1e-4, 1e-6, 1e-9}) {
    for (const char* name : {"ti.compliance", "ti.coupling", "ti.coupling_across"}) {
      Point x{45, 24.5589, (1 - gap) * limit};
      x.insert(x.end(), epoxy.begin(), epoxy.end());
      check_kept(name, x);
    }
    const double rayleigh = verify::find_quantity("halfspace.rayleigh").by_fast(Point{0.3}, {});
    check_kept("halfspace.separation", {0.3, (1 + gap) * rayleigh});
    for (const double psi : {0.0, 1e-3, 0.1, 30.0}) {
      check_kept("halfspace.compliance", {0.3, (1 - gap) * rayleigh, psi});
      check_kept("rolling.index", {0.3, (1 - gap) * rayleigh, psi});
      check_kept("rolling.strip", {0.3, (1 - gap) * rayleigh, psi});
      check_kept("rolling.creep", {0.3, (1 - gap) * rayleigh, 1e-3, psi});
      check_kept("halfspace.in_line", {0.3, (1 - gap) * rayleigh, psi});
      check_kept("halfspace.across", {0.3, (1 - gap) * rayleigh, psi});
    }
  }
}

TEST_CASE("half-spaces answer to shear at rest as plane strain and antiplane shear do") {
  for (const double nu : {-0.5, 0.0, 0.3, 0.49}) {
    CHECK(fast_at("halfspace.in_line", {nu, 0, 20}) == approx(1 - nu, 1e-15));
    CHECK(fast_at("halfspace.across", {nu, 0, 20}) == 1);
  }
  // Screw dislocations of the Lorentz contraction.
  CHECK(fast_at("halfspace.across", {0.3, 0.6, 0}) == approx(1.25, 1e-15));
}

TEST_CASE("the strip and the creep of a rolling sphere are what the index makes of them") {
  for (const double speed : {0.0, 0.3, 0.9}) {
    const double index = fast_at("rolling.index", {0.3, speed, 40});
    CHECK(fast_at("rolling.strip", {0.3, speed, 40}) ==
          approx(std::exp(-std::numbers::pi / (2 * index)), 1e-13));
    // Of no index the sphere would stretch the surface by L^2/(16 r0^2).
    const double span = 1e-3 * fast_at("rolling.span_ratio", {0.3, speed});
    const double across = fast_at("rolling.index", {0.3, speed, 90});
    CHECK(fast_at("rolling.creep", {0.3, speed, 1e-3, 90}) ==
          doctest::Approx(span * (span / 16 * (1 - 4 * across * across) + across)).epsilon(1e-14));
  }
}
