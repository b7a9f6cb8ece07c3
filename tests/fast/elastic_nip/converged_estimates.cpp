// Estimates of elastic contacts that random scenes showed to be too small.
#include <doctest/doctest.h>

#include <cmath>

#include <nipref/fast/elastic_nip/converged.hpp>

using namespace nipref;

TEST_CASE(
    "thin sheet without slip: the shear in the middle, where it is 0, rounds like what couples it to pressure") {
  const data::ElasticNip nip{
      257.67271760106087, 0.04019963248356362, {0.06679909559898078, 0.09020804732626768}};
  for (const double accuracy : {1e-8, 1e-10, 1e-13}) {
    const auto contact = fast::converged_for_length(nip, data::Friction::full, 1.3241265709511936, accuracy);
    const fast::Estimate middle = contact.shear(0);
    CHECK(middle.value == 0);
    CHECK(middle.error == 0);
    const fast::Estimate beside = contact.shear(1e-300);
    CHECK(std::fabs(beside.value) <= beside.error);
    CHECK(beside.error <= 1e-8 * contact.peak_shear().value);
  }
}

TEST_CASE("outside the contact the displacement is as sure as it is small, but for rounding") {
  const data::ElasticNip nip{100, 1, {1, 0.3}};
  for (const data::Friction friction : {data::Friction::none, data::Friction::full}) {
    const auto asked = fast::converged_for_length(nip, friction, 2, 1e-8);
    const auto truth = fast::converged_for_length(nip, friction, 2, 1e-13);
    for (const double y : {3.0, 4.5, 6.0, 9.0, 20.0}) {
      const fast::Estimate found = asked.normal_displacement(y), other = truth.normal_displacement(y);
      CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
      CHECK(found.error <= 1e-4 * std::fabs(found.value) + 1e-14 * asked.indentation().value);
    }
    CHECK(asked.normal_displacement(200).error > 0);
  }
}

TEST_CASE("what the shear next to the middle is not 0 by is an error that it knows") {
  const data::ElasticNip nip{
      7.111116296146065, 0.021914874581852928, {488122.3340148926, 0.06875329744070768}};
  const double length = 0.4987917085236404;
  const auto asked = fast::converged_for_length(nip, data::Friction::full, length, 1.4929664373219964e-05);
  for (const double y : {1e-300, 1e-12, 1e-10, 3e-10}) {
    const fast::Estimate found = asked.shear(y);
    CHECK(std::fabs(found.value + 5119.8 * y) <= found.error);  // the slope of the converged shear
  }
  CHECK(asked.shear_zeros().size() == 2);
}

TEST_CASE("without slip, some way from the end the shear lacks what its panel's slower expansion does") {
  const data::ElasticNip nip{
      83.6009410917759, 0.17480677862477023, {235288.22673034668, -0.1359571557986783}};
  const double length = 7.598592755384743;
  const auto asked = fast::converged_for_length(nip, data::Friction::full, length, 9.026356743713215e-07);
  const auto truth = fast::converged_for_length(nip, data::Friction::full, length, 1e-13);
  for (const double y : {2.057848, 2.2, 2.349350}) {
    const fast::Estimate found = asked.shear(y), other = truth.shear(y);
    CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
  }
}
