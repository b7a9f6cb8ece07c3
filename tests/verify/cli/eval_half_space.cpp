// Catalogue entries of the half-spaces on the command line: refusals, by either path; the seeds' own
// formulas.
#include <nlohmann/json.hpp>

#include "support/run_nipref.hpp"
#include "support/test.hpp"

namespace {

void check_refused(const std::string& arguments, const std::string& says) {
  for (const char* path : {"ref", "fast"}) check_call_refused("eval " + arguments + " --path " + path, says);
}

nlohmann::json eval(const std::string& arguments) {
  const Outcome outcome = run("eval " + arguments + " --json");
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  return nlohmann::json::parse(outcome.out)["results"];
}

double seed_value(const std::string& arguments) {
  const nlohmann::json results = eval(arguments);
  REQUIRE(results.size() == 1);
  CHECK(results.front().at("error").is_null());
  return results.front().at("value").get<double>();
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
  check_refused("ti.span_ratio speed=0.7", "must be below 0.6388");
}

TEST_CASE("ref refuses by itself what fast cannot even take") {
  const auto refused = [](const std::string& arguments, const std::string& says) {
    const Outcome outcome = run("eval " + arguments + " --path ref");
    CAPTURE(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find(says) != std::string::npos);
  };
  refused("halfspace.compliance poisson=0.25 speed=1e400", "speed = 1e+400: must be below 0.919402");
  refused("ti.compliance axis=in-plane speed=1e400", "speed = 1e+400: must be below 0.42835");
  // Where the nearest doubles of the speed and of the critical one are the same.
  refused("halfspace.compliance poisson=0.25 speed=0.9194016867619661219553", "must be below 0.919402");
  CHECK(run("eval halfspace.compliance poisson=0.25 speed=0.9194016867619661219552 --path ref").status == 0);
  refused("halfspace.condition poisson=0.25 speed=0.5 digits=486", "digits = 486: must be from 16 to 485");
  refused("halfspace.rayleigh poisson=0.49999999999999996", "solid = (as given): must be one whose");
  refused("ti.critical digits=600", "digits = 600: must be from 16 to 508");
}

TEST_CASE("solids, motions and choices that cannot be are refused by name") {
  check_refused("halfspace.compliance poisson=0.5 speed=0.1", "poisson = 0.5: ");
  check_refused("halfspace.rayleigh poisson=-1", "poisson = -1: ");
  check_refused("halfspace.compliance poisson=0.3 speed=-0.1", "speed = -0.1: must be a finite number >= 0");
  check_refused("die.span_ratio poisson=0.3 speed=0.1 friction=-0.1", "friction = -0.1: ");
  check_refused("ti.compliance speed=0.1 'solid=transversely-isotropic(c13=60)'", "c13 = ");
  check_refused("ti.compliance speed=0.1 'solid=transversely-isotropic(c66=0)'", "c66 = 0: ");
  check_refused("ti.compliance speed=0.1 axis=oblique", "axis = oblique: must be normal or in-plane");
  check_refused("ellipse.axis_ratio poisson=0.3 speed=0.1 curvature_ratio=0", "curvature_ratio = 0: ");
  check_refused("ellipse.stiffness poisson=0.3 speed=0.1 curvature_ratio=-1", "curvature_ratio = -1: ");
  check_refused("ti.condition axis=in-plane theta_deg=45 speed=0.5", "must be below 0.49899605");
  check_refused(
      "anisotropic.compliance speed=0.1 'solid=anisotropic(stiffness=[1,2,2,0,0,0,1,2,0,0,0,1,0,0,0,1,0,0,1,0,1],"
      "density=1)'",
      "stiffness = ");
  check_refused("anisotropic.compliance speed=0.1 c11=0",
                "c11 = 0: is part of the solid: solid=anisotropic(stiffness=");
  check_refused("anisotropic.coupling speed=1.6 theta_deg=45 psi_deg=24.5589",
                "speed = 1.6: must be below 1.5638");
  check_refused("ti.branch which=57", "which = 57: must be 56 or plus or minus");
}

TEST_CASE("form=table gives the numbers that stand in the papers' tables") {
  // brock2012, Table 1, gamma = 0.1, c = 0.6, and Table 2, c = 0.1 and 0.6; brock2013, Table 1, gamma = 0, c0
  // = 0.05.
  CHECK(std::fabs(seed_value("die.span_ratio poisson=0.33333333333 speed=0.6 friction=0.1 form=table") -
                  0.7049) < 1e-4);
  CHECK(std::fabs(seed_value("rolling.span_ratio poisson=0.33333333333 speed=0.6 form=table") - 0.7318) <
        1e-4);
}

TEST_CASE("form=printed differs from what is right as the seed's slips make it") {
  // At rest the factor c_D = 2 under the root of (53b) leaves the square root of 2.
  CHECK(seed_value("rolling.span_ratio poisson=0.33333333333 speed=1e-3 form=printed") ==
        doctest::Approx(std::sqrt(2.)).epsilon(1e-4));
  // (35) at rest where the circle demands 1.
  CHECK(seed_value("ti.span_ratio speed=0 form=printed") == doctest::Approx(1 / 1.87).epsilon(0.01));
  CHECK(eval("ti.span_ratio speed=0 path=fast")["fast"]["value"] == 1);
  // K of lines across the axis is that of the isotropic plane: there the missing term vanishes.
  const double across = seed_value("ti.compliance axis=in-plane speed=0.2 form=table");
  const double right = eval("ti.compliance axis=in-plane speed=0.2 path=fast")["fast"]["value"].get<double>();
  CHECK(across == doctest::Approx(right).epsilon(1e-12));
}

TEST_CASE("form=printed of a rolling sphere and of the shear") {
  CHECK(seed_value("halfspace.in_line poisson=0.3 speed=0.5 form=printed") == 0);
  // The sphere would run ahead where it lags.
  CHECK(seed_value("rolling.creep poisson=0.3 speed=0.5 span_over_radius=1e-3 form=printed") < 0);
  check_refused("halfspace.separation poisson=0.3 speed=0.9", "speed = 0.9: must be ");
  check_refused("halfspace.compliance_beyond poisson=0.3 speed=0.9",
                "speed = 0.9: must be, along the line, between those of Rayleigh and of shear waves");
  check_refused("halfspace.separation poisson=0.3 speed=1.1", "speed = 1.1: must be ");
  check_refused("rolling.creep poisson=0.3 speed=0.9 span_over_radius=20", "span = ");
}

TEST_CASE("form=printed of a sphere that slides on graphite epoxy") {
  // What steel has of a coupling is added where it subtracts.
  const auto fast = [](const std::string& arguments) {
    return eval(arguments + " path=fast")["fast"]["value"].get<double>();
  };
  const std::string at = "ti.exponent speed=0.1 friction=1e-3", steel = " poisson=0.29529 speed=0.1";
  const double both = fast("ti.compliance speed=0.1") + fast("halfspace.compliance" + steel);
  const double expected = 2e-3 * fast("halfspace.coupling" + steel) / (std::numbers::pi * both);
  CHECK(seed_value(at + " form=printed") - fast(at) == doctest::Approx(expected).scale(0).epsilon(1e-5));
  // Without friction 1/Q^2 leaves out a factor of 2, the interchanged exponents nothing.
  const double force = fast("ti.force speed=0.2");
  CHECK(seed_value("ti.force speed=0.2 form=printed") == doctest::Approx(force / 2).scale(0).epsilon(1e-10));
  // (47) is right where (43) is: nowhere off the axes.
  const double oblique = fast("ti.force axis=in-plane theta_deg=45 speed=0.2");
  CHECK(std::fabs(seed_value("ti.force axis=in-plane theta_deg=45 speed=0.2 form=printed") / oblique - 1) >
        0.01);
}

TEST_CASE("forms that the seed does not have are refused") {
  check_refused("I1 alpha=1 form=table", "form = table: must be corrected of I1");
  check_refused("rolling.span_ratio poisson=0.3 speed=0.1 form=typed",
                "form = typed: must be corrected or printed or table of rolling.span_ratio");
  check_refused("rolling.span_ratio poisson=0.3 speed=0.1 form=printed",
                "must be left out with form=printed");
  const auto refused = [](const std::string& arguments, const std::string& says) {
    const Outcome outcome = run("eval " + arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find(says) != std::string::npos);
  };
  refused("rolling.span_ratio poisson=0.3 speed=0.95 form=printed", "speed = 0.95: must be below");
  refused("ti.compliance speed=0.1 form=printed", "axis = normal: must be in-plane");
  refused("ti.span_ratio speed=0.1 axis=in-plane friction=0.1 form=table", "friction = 0.1: must be 0");
  refused("ti.force speed=0.1 patch=fixed form=printed", "patch = fixed: must be moving");
  refused("ti.exponent speed=0.1 axis=in-plane friction=0.1 form=printed", "friction = 0.1: must be 0");
  refused("ti.span_ratio speed=0.1 phi_deg=30 form=printed", "phi_deg = 30: must be 90");
  refused("ti.span_ratio speed=0.1 patch=fixed form=table", "patch = fixed: must be moving");
}
