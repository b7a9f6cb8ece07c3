#include <doctest/doctest.h>

#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/internal/grip_expansion.hpp>
#include <nipref/ref/elastic_nip/thin_gripped.hpp>
#include <nipref/ref/number/caches.hpp>

using namespace nipref;

TEST_CASE(
    "a long contact with full friction is by the reference, from shorter ones, what fast's panels solve") {
  const data::ElasticNip nip{500, 2, {3, 0.4}};
  const double length = 120;  // shorter ones: L/B 5 to 7.5
  const ref::ThinGrippedNip thin = ref::thin_gripped_nip_of_length(nip, length, 12);
  const auto panels = fast::converged_for_length(nip, data::Friction::full, length, 1e-13);
  const auto check = [](const ref::Estimate& truth, const fast::Estimate& found) {
    const double error = mpfr_get_d(ref::raw(truth.error), MPFR_RNDU);
    CHECK(std::fabs(truth.error_of(found.value)) <= found.error + error);
    CHECK(error < 1e-12 * std::fabs(found.value));
    CHECK(found.error < 1e-10 * std::fabs(found.value));
  };
  check(thin.load, panels.load());
  check(thin.indentation, panels.indentation());
  check(thin.creep_ratio, panels.creep_ratio());
  check(thin.middle_pressure, panels.pressure(0));
  check(thin.peak_shear, panels.peak_shear());
}

TEST_CASE("long contacts with full friction: six shorter ones serve all lengths of a sheet") {
  ref::clear_caches();
  const auto solved_for = [](double length) {
    const long before = ref::GripExpansion::solved();
    static_cast<void>(ref::thin_gripped_nip_of_length({500, 2, {3, 0.4}}, length, 12));
    return ref::GripExpansion::solved() - before;
  };
  CHECK(solved_for(120) == 6);
  CHECK(solved_for(80) == 0);
}

TEST_CASE("long contacts with full friction: what is refused") {
  const auto of = [](double poisson, double length, int digits) {
    static_cast<void>(ref::thin_gripped_nip_of_length({500, 2, {3, poisson}}, length, digits));
  };
  CHECK_THROWS_WITH_AS(of(0.3, 23, 16), doctest::Contains("contact_length = 23: must be at most"),
                       data::BadInput);
  CHECK_THROWS_WITH_AS(of(0.3, 501, 16), doctest::Contains("contact_length = 501: must be at most"),
                       data::BadInput);
  CHECK_THROWS_WITH_AS(of(0.4999999, 40, 16),
                       doctest::Contains("poisson = 0.4999999: must be at most 0.499999"), data::BadInput);
  CHECK_THROWS_WITH_AS(of(0.3, 40, 30), doctest::Contains("digits = 30: must be from 12 to 21"),
                       data::BadInput);
}
