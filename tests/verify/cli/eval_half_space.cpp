// Catalogue entries of the half-spaces on the command line: the seeds' own formulas.
#include <nlohmann/json.hpp>

#include "support/run_nipref.hpp"
#include "support/test.hpp"

namespace {

nlohmann::json eval(const std::string& arguments) { return answer_to("eval " + arguments)["results"]; }

double seed_value(const std::string& arguments) {
  const nlohmann::json results = eval(arguments);
  REQUIRE(results.size() == 1);
  CHECK(results.front().at("error").is_null());
  return results.front().at("value").get<double>();
}

}  // namespace

TEST_CASE("ref answers where the nearest doubles of the speed and of the critical one are the same") {
  CHECK(run("eval halfspace.compliance poisson=0.25 speed=0.9194016867619661219552 --path ref").status == 0);
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
}

TEST_CASE("form=printed of a sphere that slides on graphite epoxy") {
  // What steel has of a coupling is added where it subtracts.
  const auto fast = [](const std::string& arguments) {
    return eval(arguments + " path=fast")["fast"]["value"].get<double>();
  };
  const std::string at = "ti.exponent speed=0.1 friction=1e-3", steel = " poisson=0.29529 speed=0.1";
  const double both = fast("ti.compliance speed=0.1") + fast("halfspace.compliance" + steel);
  const double expected = 2e-3 * fast("halfspace.coupling" + steel) / (std::numbers::pi * both);
  CHECK(seed_value(at + " form=printed") - fast(at) == approx(expected, 1e-5));
  // Without friction 1/Q^2 leaves out a factor of 2, the interchanged exponents nothing.
  const double force = fast("ti.force speed=0.2");
  CHECK(seed_value("ti.force speed=0.2 form=printed") == approx(force / 2, 1e-10));
  // (47) is right where (43) is: nowhere off the axes.
  const double oblique = fast("ti.force axis=in-plane theta_deg=45 speed=0.2");
  CHECK(std::fabs(seed_value("ti.force axis=in-plane theta_deg=45 speed=0.2 form=printed") / oblique - 1) >
        0.01);
}
