// Catalogue entries of the half-spaces on the command line: the seeds' own formulas.
#include <nlohmann/json.hpp>

#include "support/run_nipref.hpp"
#include "support/test.hpp"

TEST_CASE("form=printed of a sphere that slides on graphite epoxy") {
  const auto value = [](const std::string& arguments) {
    return answer_to("eval " + arguments)["results"].front()["value"].get<double>();
  };
  const auto fast = [&](const std::string& arguments) { return value(arguments + " path=fast"); };
  // What steel has of a coupling is added where it subtracts.
  const std::string at = "ti.exponent speed=0.1 friction=1e-3", steel = " poisson=0.29529 speed=0.1";
  const double both = fast("ti.compliance speed=0.1") + fast("halfspace.compliance" + steel);
  const double expected = 2e-3 * fast("halfspace.coupling" + steel) / (std::numbers::pi * both);
  CHECK(value(at + " form=printed") - fast(at) == approx(expected, 1e-5));
  // Without friction 1/Q^2 leaves out a factor of 2, the interchanged exponents nothing.
  CHECK(value("ti.force speed=0.2 form=printed") == approx(fast("ti.force speed=0.2") / 2, 1e-10));
  // (47) is right where (43) is: nowhere off the axes.
  const std::string oblique = "ti.force axis=in-plane theta_deg=45 speed=0.2";
  CHECK(std::fabs(value(oblique + " form=printed") / fast(oblique) - 1) > 0.01);
  // K of lines across the axis is that of the isotropic plane: there the missing term vanishes.
  const std::string across = "ti.compliance axis=in-plane speed=0.2";
  CHECK(value(across + " form=table") == approx(fast(across), 1e-12));
}
