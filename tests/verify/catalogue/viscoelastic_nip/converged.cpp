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
  // The second: the shortest contacts of sheets that soften much.
  for (const Point& point : {Point{0.02, 5, 1.0 / 3, 2, 1}, Point{1e-6, 4.4, 0.4999999, 101, 0}}) {
    for (const char* number : {"resistance", "leading_share", "load", "indentation", "creep"}) {
      CAPTURE(number);
      const verify::Quantity& quantity = verify::find_quantity(std::string("rolling_nip.") + number);
      const ref::Estimate truth = verify::ref_value(quantity, point, 16);
      const double value = quantity.by_fast(point, {});
      CHECK(truth.proven == (std::string(number) != "creep"));
      CHECK(std::fabs(truth.error_of(value)) <= quantity.fast_error(point, {}));
      CHECK(verify::deviation(value, truth, quantity.envelope(point)).ulps <= quantity.promise);
    }
  }
}
