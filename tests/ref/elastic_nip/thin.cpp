#include <doctest/doctest.h>

#include <cmath>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/thin.hpp>

using namespace nipref;

TEST_CASE(
    "numbers of a long contact are those of the contact that is solved, with another layer of the sheet's") {
  const data::ElasticNip nip{200, 2, {3, 0.3}};
  // Between the lengths that it is known from, 10 to 16.
  const double length = 26;
  const ref::LongContactFit thin = ref::thin_nip_of_length(nip, length, 18);
  const ref::ConvergedElasticNip contact = ref::converged_for_length(nip, length, 18);
  const auto check = [](const ref::Estimate& found, const ref::Enclosure& truth) {
    ref::Float distance = ref::zero_of_bits(64);
    mpfr_sub(ref::raw(distance), ref::raw(found.value), ref::raw(truth.value), MPFR_RNDA);
    const double allowed =
        mpfr_get_d(ref::raw(found.error), MPFR_RNDU) + mpfr_get_d(ref::raw(truth.error), MPFR_RNDU);
    CHECK(std::fabs(mpfr_get_d(ref::raw(distance), MPFR_RNDA)) <= allowed);
    CHECK(allowed <
          1e-16 * std::fabs(truth.to_double()));  // of the displacements, that is, not of the strain
  };
  check(thin.load, contact.load());
  check(thin.indentation, contact.indentation());
  check(thin.creep_ratio, contact.creep_ratio());
  check(thin.peak_pressure, contact.peak_pressure());
}

TEST_CASE(
    "the pressure in the middle of a long contact is that of springs, but for waves that its error covers") {
  const data::ElasticNip nip{1024, 1, {1, 0.3}};
  // Between the lengths that it is known from, at the last of them, and beyond.
  for (const auto& [length, most] :
       {std::pair(11.0, 1e-13), std::pair(16.0, 1e-20), std::pair(20.0, 1e-23)}) {
    CAPTURE(length);
    const ref::Estimate found = ref::thin_nip_of_length(nip, length, 21).peak_pressure;
    const ref::Enclosure truth = ref::converged_for_length(nip, length, 26).peak_pressure();
    ref::Float distance = ref::zero_of_bits(64);
    mpfr_sub(ref::raw(distance), ref::raw(found.value), ref::raw(truth.value), MPFR_RNDA);
    mpfr_abs(ref::raw(distance), ref::raw(distance), MPFR_RNDA);
    mpfr_add(ref::raw(distance), ref::raw(distance), ref::raw(truth.error), MPFR_RNDU);
    const double error = mpfr_get_d(ref::raw(found.error), MPFR_RNDU);
    CHECK(mpfr_get_d(ref::raw(distance), MPFR_RNDU) <= error);
    CHECK(error <= most * truth.to_double());
  }
}

TEST_CASE("contacts are long from where their ends no longer feel each other") {
  const data::ElasticNip nip{200, 1, {3, 0.3}};
  CHECK(ref::shortest_thin_nip(21) == 10);
  CHECK_THROWS_WITH_AS(ref::thin_nip_of_length(nip, 9, 18), doctest::Contains("contact_length = 9: must be"),
                       data::BadInput);
  CHECK_THROWS_WITH_AS(ref::thin_nip_of_length(nip, 201, 18),
                       doctest::Contains("contact_length = 201: must be"), data::BadInput);
  CHECK_THROWS_WITH_AS(ref::thin_nip_of_length(nip, 20, 90), doctest::Contains("digits = 90"),
                       data::BadInput);
}
