#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/deviation.hpp>

#include "support/test.hpp"

using namespace nipref;
using verify::Point;

namespace {

double rolling(const std::string& number, const Point& point) {
  return verify::find_quantity("rolling_nip." + number).by_fast(point, {});
}
double at_rest(const std::string& number, double length, double poisson) {
  return verify::find_quantity("nip." + number).by_fast(Point{length, poisson, 0}, {});
}

}  // namespace

TEST_CASE(
    "dimensionless rolling nips: a memory far longer than the contact is none, a far shorter one a softer sheet") {
  for (const double length : {1e-3, 0.5, 8.0}) {
    const double poisson = 0.3, softening = 4;
    const Point glassy{length, 1e8, poisson, softening, 0}, rubbery{length, 1e-8, poisson, softening, 0};
    CAPTURE(length);
    for (const char* number : {"indentation", "creep"}) {
      CHECK(rolling(number, glassy) == doctest::Approx(at_rest(number, length, poisson)).epsilon(1e-6));
      CHECK(rolling(number, rubbery) == doctest::Approx(at_rest(number, length, poisson)).epsilon(1e-6));
    }
    CHECK(rolling("load", glassy) == doctest::Approx(at_rest("load", length, poisson)).epsilon(1e-6));
    CHECK(softening * rolling("load", rubbery) ==
          doctest::Approx(at_rest("load", length, poisson)).epsilon(1e-6));
    for (const Point& point : {glassy, rubbery}) {
      CHECK(rolling("leading_share", point) == doctest::Approx(0.5).epsilon(1e-6));
      CHECK(std::fabs(rolling("resistance", point)) < 1e-6);
    }
    // In between it costs something, and the contact is ahead of the rollers.
    const Point between{length, 1, poisson, softening, 0};
    CHECK(rolling("resistance", between) > 0.01);
    CHECK(rolling("leading_share", between) > 0.51);
  }
}

TEST_CASE("dimensionless rolling nips: fast's errors are covered, and all but the creep is proven") {
  const Point point{0.02, 5, 1.0 / 3, 2, 1};
  for (const char* number : {"resistance", "leading_share", "load", "indentation", "creep"}) {
    const verify::Quantity& quantity = verify::find_quantity(std::string("rolling_nip.") + number);
    const ref::Estimate truth = verify::ref_value(quantity, point, 18);
    CHECK(truth.proven == (std::string(number) != "creep"));
    CHECK(std::fabs(truth.error_of(quantity.by_fast(point, {}))) <= quantity.fast_error(point, {}));
  }
}

TEST_CASE("dimensionless rolling nips: promises hold for the shortest contacts of sheets that soften much") {
  const Point point{1e-6, 4.4, 0.4999999, 101, 0};
  for (const char* number : {"resistance", "leading_share", "load", "indentation", "creep"}) {
    CAPTURE(number);
    const verify::Quantity& quantity = verify::find_quantity(std::string("rolling_nip.") + number);
    const ref::Estimate truth = verify::ref_value(quantity, point, 16);
    CHECK(verify::deviation(quantity.by_fast(point, {}), truth, quantity.envelope(point)).ulps <=
          quantity.promise);
  }
}

TEST_CASE("dimensionless rolling nips: refusals name the argument") {
  const auto refused = [](const Point& point) {
    static_cast<void>(verify::find_quantity("rolling_nip.load").by_fast(point, {}));
  };
  CHECK_THROWS_WITH_AS(refused({1, 1e9, 0.3, 2, 0}), "memory_over_L = 1000000000: must be from 1e-8 to 1e8",
                       data::BadInput);
  CHECK_THROWS_WITH_AS(refused({1, 1, 0.5, 2, 0}), doctest::Contains("poisson = 0.5: must satisfy"),
                       data::BadInput);
  CHECK_THROWS_WITH_AS(refused({1, 1, 0.3, 1, 0}), doctest::Contains("softening = 1: must be > 1"),
                       data::BadInput);
  CHECK_THROWS_WITH_AS(refused({0, 1, 0.3, 2, 0}), doctest::Contains("L_over_B = 0"), data::BadInput);
}

TEST_CASE("dimensionless rolling nips: the reference refuses what takes it longer than ten seconds") {
  const verify::Quantity& load = verify::find_quantity("rolling_nip.load");
  const auto ref = [&](double length, double memory, int digits, double softening = 2) {
    static_cast<void>(verify::ref_value(load, Point{length, memory, 0.3, softening, 0}, digits));
  };
  CHECK_THROWS_WITH_AS(
      ref(0.01, 0.005, 30),
      doctest::Contains(
          "digits = 30: must be at most 28 for L_over_B = 0.01, memory_over_L = 0.005 and softening = 2"),
      data::BadInput);
  CHECK_THROWS_WITH_AS(ref(1e-7, 1, 16), doctest::Contains("L_over_B = 1e-07: must be at least 1e-6"),
                       data::BadInput);
  CHECK_THROWS_WITH_AS(ref(10, 1e-6, 16),
                       doctest::Contains("L_over_B = 10: must be smaller, or memory_over_L"), data::BadInput);
  // A solid that softens much does so within a small part of its memory.
  CHECK_THROWS_WITH_AS(ref(1, 1, 16, 700000), doctest::Contains("softening = 700000 take it too long"),
                       data::BadInput);
}
