// Work and loss of rolling nips, by either path.
#include <nipref/fast/material/functions.hpp>
#include <nipref/verify/solve/energy_balance.hpp>

#include "support/softening_sheet.hpp"
#include "support/solved_scene.hpp"

using namespace nipref;

namespace {

data::Scene rolling_scene(const data::ViscoelasticNip& nip, double length) {
  const data::ViscoelasticNipProblem problem{.nip = nip, .given = data::GivenLength{length}};
  return scene_wanting(problem, {data::ResultId::load}, 1e-12);
}

void check_balanced(const verify::EnergyBalance& balance, double known_to) {
  CHECK(balance.work.value > 0);
  CHECK(balance.meets());
  CHECK(balance.allowed() <= known_to * balance.work.value);
}

}  // namespace

TEST_CASE("energy balance: the resistance's work is what the sheet loses at all frequencies") {
  // A solid with the shear rates 2 +- 2i, and a fluid, which loses energy however slowly it is loaded.
  const data::ViscoelasticMaterial waves = data::operator_solid({{9, 4.5, 1}, {8, 4, 1}, {1}, {10}});
  REQUIRE(fast::material_functions(waves).theta1.terms.front().rate.imag() != 0);
  const data::ViscoelasticNip waving{6, 0.25, waves, 0.2},
      flowing{6, 0.25, {{1e-5, {{8e-5, 0}}}, {4e-6, {{1e-5, 0}}}}, 1};
  for (const data::ViscoelasticNip& nip : {test::nip(1), waving})
    check_balanced(verify::energy_balance(rolling_scene(nip, 0.1), 16), 1e-13);
  check_balanced(verify::energy_balance(rolling_scene(test::nip(1), 0.1)), 1e-9);
  check_balanced(verify::energy_balance(rolling_scene(flowing, 0.1)), 1e-9);
  for (const double memory : {1e-4, 1e3})
    check_balanced(verify::energy_balance(rolling_scene(test::nip(memory), 0.1)), 1e-8);
}

TEST_CASE("energy balance: what has no memory loses nothing") {
  const data::ViscoelasticNip nip{6, 0.25, data::elastic_solid({1e5, 0.3}), 1};
  const auto balance = verify::energy_balance(rolling_scene(nip, 0.1));
  CHECK(balance.loss.value == 0);
  CHECK(balance.meets());
}

TEST_CASE("energy balance: a wrong pressure is seen unless its stated error covers it") {
  const data::ViscoelasticNip nip = test::nip(0.1);
  const auto loss = [&](double lean, double error) {
    return verify::loss_integral(nip, -0.05, 0.05, [=](double y) -> fast::Estimate {
      const double x = y / 0.05;
      return {(1 + lean * x) * std::sqrt(1 - x * x), error};
    });
  };
  const fast::Estimate right = loss(0, 0), wrong = loss(1e-3, 0), unsure = loss(0, 1e-3);
  CHECK(right.error <= 1e-12 * right.value);
  CHECK(std::fabs(wrong.value - right.value) > wrong.error + right.error);
  CHECK(std::fabs(wrong.value - right.value) <= unsure.error);
}
