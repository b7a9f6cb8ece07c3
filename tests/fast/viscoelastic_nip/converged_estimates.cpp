// Errors of converged contacts where what they are of is small.
#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>

#include "support/covered.hpp"
#include "support/test.hpp"

using namespace nipref;

TEST_CASE("thin sheet without slip: the shear in the middle is exactly 0, and beside it rounds little") {
  const data::ElasticNip nip{
      257.67271760106087, 0.04019963248356362, {0.06679909559898078, 0.09020804732626768}};
  for (const double accuracy : {1e-8, 1e-10, 1e-13}) {
    const auto contact = fast::converged_for_length(nip, data::Friction::full, 1.3241265709511936, accuracy);
    CHECK(contact.shear(0).value == 0);
    CHECK(contact.shear(0).error == 0);
    check_covered(contact.shear(1e-300), {});
    CHECK(contact.shear(1e-300).error <= 1e-8 * contact.peak_shear().value);
  }
}

TEST_CASE(
    "outside a contact the displacement is as sure as it is small, behind a rolling one like its memory") {
  const auto check = [](const auto& solved, const std::vector<double>& places) {
    const auto asked = solved(1e-8), truth = solved(1e-13);
    for (const double y : places) {
      const fast::Estimate found = asked.normal_displacement(y);
      check_covered(found, truth.normal_displacement(y));
      CHECK(found.error <= 1e-4 * std::fabs(found.value) + 1e-14 * asked.indentation().value);
    }
  };
  for (const data::Friction friction : {data::Friction::none, data::Friction::full}) {
    const auto solved = [&](double accuracy) {
      return fast::converged_for_length(data::ElasticNip{100, 1, {1, 0.3}}, friction, 2, accuracy);
    };
    check(solved, {3.0, 4.5, 6.0, 9.0, 20.0});
    CHECK(solved(1e-8).normal_displacement(200).error > 0);
  }
  const data::ViscoelasticNip rolling{100, 1, data::single_relaxation_time_solid(2, 1, 0.25), 1};
  check([&](double accuracy) { return fast::converged_for_length(rolling, 2, accuracy); },
        {-20.0, -9.0, -6.0, -3.0, 3.0, 4.5, 6.0, 9.0, 20.0});
}

TEST_CASE("next to the leading end the strain rounds as the pressure does that makes it at once") {
  const data::ViscoelasticNip nip{15660.851572036743, 1.854786531534046,
                                  data::operator_solid({{34480.27462387085, 1.0},
                                                        {243385.40824890137, 329.2721646130085},
                                                        {0.00040817430831907586, 1.0},
                                                        {0.00536199903308443, 612.7908380031586}}),
                                  0.012102478431188501};
  const auto contact = fast::converged_for_length(nip, 0.008795065559752402, 2.7259528381578472e-11);
  const double y = 0.004396866668230359;
  const fast::Estimate strain = contact.surface_strain(y), pressure = contact.pressure(y);
  // Nearly all of the strain is theta2 times the pressure there.
  CHECK(strain.error / std::fabs(strain.value) > 0.3 * pressure.error / pressure.value);
}
