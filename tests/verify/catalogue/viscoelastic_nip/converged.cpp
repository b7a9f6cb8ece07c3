#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/deviation.hpp>

#include "support/test.hpp"

using namespace nipref;
using verify::Point;

TEST_CASE("dimensionless rolling nips: fast's errors are covered, and all but the creep is proven") {
  // The second point has the shortest contact, of a sheet that softens much.
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
