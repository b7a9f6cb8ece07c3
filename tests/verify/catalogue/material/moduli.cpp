// Rows of materials: every model on both paths, confirmed by the golden values' second method; names and refusals.
#include <doctest/doctest.h>

#include <string>

#include <nipref/verify/audit/internal/sampling.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/golden/confirm/confirm.hpp>
#include <nipref/verify/golden/make.hpp>

#include "support/run_nipref.hpp"

using namespace nipref;

TEST_CASE("materials: series, operators and the thesis's solid are confirmed by a second method") {
  for (const verify::Quantity& quantity : verify::catalogue()) {
    if (!quantity.name.starts_with("material.")) continue;
    CAPTURE(quantity.name);
    verify::Random random("second method");
    for (const double model : {4.0, 5.0, 6.0}) {
      for (int i = 0; i < 5; ++i) {
        verify::Point point = quantity.draw(random);
        point[1] = model;
        CAPTURE(point[0]);
        const ref::Estimate truth = verify::ref_value(quantity, point, 30);
        CHECK(truth.proven);
        verify::GoldenRow row = verify::golden_row(quantity, point, truth);
        CHECK(verify::confirm_row(quantity, row) == "");
        CHECK(std::fabs(truth.error_of(quantity.by_fast(point, {}))) <= quantity.fast_error(point, {}));
      }
    }
  }
}

TEST_CASE("materials: constants of a model are arguments by the names that a scene has them by") {
  const auto value = [](const std::string& arguments) {
    const Outcome outcome = run("eval " + arguments + " --path ref --digits 20 --json");
    CHECK(outcome.status == 0);
    return outcome.out.substr(outcome.out.find("\"value\""), 30);
  };
  const std::string springs = value("material.G t=0.7");
  CHECK(value("material.G t=0.7 material=operators") == springs);
  CHECK(value("material.G t=0.7 material=operators P_0=1 P_1=0.5 Q_0=0.1875 Q_1=0.1875") == springs);
  CHECK(
      value("material.theta1 t=0.7 material=prony theta1_amplitude=3 theta1_rate_2=1 theta1_amplitude_2=1") ==
      value("material.theta1 t=0.7 material=prony theta1_amplitude=4"));
}

TEST_CASE("materials: what is no solid is refused in one line") {
  check_call_refused("eval material.G t=1 material=rubber", "material = rubber");
  check_call_refused("eval material.G t=1 material=prony theta1_rate=-1", "theta1_rate = -1");
  check_call_refused("eval material.G t=1 material=operators Q_2=0 Q_1=0", "Q = of degree 0");
  check_call_refused("eval material.K t=1 material=thesis tau=0", "tau = 0");
  check_call_refused("eval material.creep_bulk t=1 material=prony theta2_instantaneous=3 theta2_amplitude=3",
                     "theta2 = 3 theta1 at all times");
  check_call_refused("eval material.theta1 t=1e10 material=prony", "t = 1");
}
