// The promises of fast for half-spaces hold for the arguments as they are given, to the ends of the domain: angles in
// degrees, constants in GPa, speeds next to the critical one.
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/deviation.hpp>

#include "support/test.hpp"

using namespace nipref;
using verify::Point;

namespace {

void check_kept(const char* name, const Point& point) {
  CAPTURE(name);
  const verify::Quantity& quantity = verify::find_quantity(name);
  const std::vector<ref::Exact> exactly(point.begin(), point.end());
  const ref::Estimate truth = quantity.by_ref(exactly, verify::digits_beyond_double);
  const double value = quantity.by_fast(point, {});
  CHECK(verify::deviation(value, truth, quantity.envelope(point)).ulps <= quantity.promise);
}

constexpr double in_plane = 1;

}  // namespace

TEST_CASE("half-spaces in degrees, GPa and speeds of steel keep the promise where they once did not") {
  check_kept("halfspace.coupling", {0x1.fffff94a03595p-2, 0x1.e91e97e2fdb23p-1, 45});
  check_kept("rolling.index", {0x1.3333333333333p-2, 0x1.dad5d6ac2bda0p-1, 0});
  // A moment is nearly 0 here. No number of panels resolves its rounding errors.
  check_kept("die.force", {0x1.ffffff543388fp-2, 0x1p-1074, 0x1.fffffffffffffp-1});
  for (const char* name : {"ti.compliance", "ti.coupling", "ti.coupling_across"})
    check_kept(name, {0, 135, 0x1.bcb952498e366p-3, in_plane, 10, 10, 0x1.2cccccccccccdp+3, 9, 1, 1000});
}

TEST_CASE("half-spaces next to the critical speed: the promises hold on critical lines") {
  // The seed's solid, moving at 45 degrees from the axis. The critical line is 20 degrees off the motion.
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
