// Catalogue entries of the half-spaces on the command line: refusals, by either path.
#include <doctest/doctest.h>

#include <string>

#include "run_nipref.hpp"

namespace {

void check_refused(const std::string& arguments, const std::string& says) {
  for (const char* path : {"ref", "fast"}) {
    const Outcome outcome = run("eval " + arguments + " --path " + path);
    CAPTURE(arguments);
    CAPTURE(path);
    CAPTURE(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find(says) != std::string::npos);
    CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
  }
}

}  // namespace

TEST_CASE("speeds that are not subcritical are refused with the limit and its line") {
  // The Rayleigh speed of nu = 0.3; at 60 degrees from the motion twice as much.
  check_refused("halfspace.compliance poisson=0.3 speed=0.93", "speed = 0.93: must be below 0.927413");
  check_refused("halfspace.coupling poisson=0.3 speed=1.9 psi_deg=60",
                "must be below 1.85483, which is critical on lines 60");
  check_refused("die.force poisson=0.3 friction=0.1 speed=0.93", "speed = 0.93: must be below 0.927413");
  check_refused("rolling.index poisson=0.3 speed=0.93", "speed = 0.93: must be below 0.927413");
  check_refused("ellipse.axis_ratio poisson=0.3 speed=0.93", "speed = 0.93: must be below 0.927413");
  check_refused("ti.compliance axis=in-plane theta_deg=45 speed=0.5", "must be below 0.49899605");
  check_refused("ti.compliance axis=in-plane theta_deg=45 speed=0.5", "psi = 24.5589 degrees");
  check_refused("ti.span_ratio speed=0.7", "must be below 0.638829");
}

TEST_CASE("solids, motions and choices that cannot be are refused by name") {
  check_refused("halfspace.compliance poisson=0.5 speed=0.1", "poisson = 0.5: ");
  check_refused("halfspace.rayleigh poisson=-1", "poisson = -1: ");
  check_refused("halfspace.compliance poisson=0.3 speed=-0.1", "speed = -0.1: must be a finite number >= 0");
  check_refused("die.span_ratio poisson=0.3 speed=0.1 friction=-0.1", "friction = -0.1: ");
  check_refused("ti.compliance speed=0.1 c13=60", "c13 = ");
  check_refused("ti.compliance speed=0.1 c66=0", "c66 = 0: ");
  check_refused("ti.compliance speed=0.1 axis=oblique", "axis = oblique: must be normal or in-plane");
  check_refused("ti.branch which=57", "which = 57: must be 56 or plus or minus");
}
