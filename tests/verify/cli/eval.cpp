#include "support/run_nipref.hpp"

using nlohmann::json;

TEST_CASE("a sweep's row is what eval says at its arguments, and rows come in the order of their arguments") {
  const json columns =
      answer_to("eval I6 alpha=0x1p-3,7.5 eta=0.1..10:log --points 40 --digits 20").at("columns");
  REQUIRE(columns.at("alpha").size() == 80);
  for (const std::size_t row : {0U, 17U, 39U, 40U, 79U}) {
    CAPTURE(row);
    CHECK(columns["alpha"][row] == (row < 40 ? "0x1p-3" : "7.5"));
    const json answer = answer_to("eval I6 alpha=" + columns["alpha"][row].get<std::string>() + " eta=" +
                                  columns["eta"][row].get<std::string>() + " --path fast")["results"]["fast"];
    CHECK(columns["fast"][row] == answer.at("value"));
    CHECK(columns["fast_error"][row] == answer.at("error"));
    const double ref = std::stod(columns["ref"][row].get<std::string>());
    CHECK(std::fabs(ref - columns["fast"][row].get<double>()) <= columns["fast_error"][row].get<double>());
  }
  CHECK(std::stod(columns["eta"][0].get<std::string>()) == 0.1);
  CHECK(std::stod(columns["eta"][39].get<std::string>()) == 10);
}

TEST_CASE("form=printed of a sphere that slides on graphite epoxy has the errors of the printed formulas") {
  const auto value = [](const std::string& arguments) {
    return answer_to("eval " + arguments)["results"].front()["value"].get<double>();
  };
  const auto fast = [&](const std::string& arguments) { return value(arguments + " path=fast"); };
  // The printed formula adds the coupling of steel, which is to be subtracted.
  const std::string at = "ti.exponent speed=0.1 friction=1e-3", steel = " poisson=0.29529 speed=0.1";
  const double both = fast("ti.compliance speed=0.1") + fast("halfspace.compliance" + steel);
  const double expected = 2e-3 * fast("halfspace.coupling" + steel) / (std::numbers::pi * both);
  CHECK(value(at + " form=printed") - fast(at) == approx(expected, 1e-5));
  // Without friction the printed 1/Q^2 loses a factor of 2. The interchanged exponents have no effect.
  CHECK(value("ti.force speed=0.2 form=printed") == approx(fast("ti.force speed=0.2") / 2, 1e-10));
  // (47) is right only where (43) is, and (43) is right nowhere off the axes.
  const std::string oblique = "ti.force axis=in-plane theta_deg=45 speed=0.2";
  CHECK(std::fabs(value(oblique + " form=printed") / fast(oblique) - 1) > 0.01);
  // K of lines across the axis is that of the isotropic plane, where the missing term vanishes.
  const std::string across = "ti.compliance axis=in-plane speed=0.2";
  CHECK(value(across + " form=table") == approx(fast(across), 1e-12));
}
