#include <nipref/verify/catalogue/deviation.hpp>

#include "support/test.hpp"

using nipref::verify::ulp_of;

TEST_CASE("an ulp is the distance to the next larger double") {
  for (const double scale :
       {1.0, 1.5, 0x1.fffffffffffffp0, 2.0, 1e-300, 1e300, 0x1p-1022, 0x1p-1023, 0x1p-1074}) {
    CAPTURE(scale);
    CHECK(ulp_of(scale) == std::nextafter(scale, std::numeric_limits<double>::infinity()) - scale);
    CHECK(ulp_of(-scale) == ulp_of(scale));
  }
}

TEST_CASE("an ulp is never below the smallest double") { CHECK(ulp_of(0) == 0x1p-1074); }

TEST_CASE("an ulp of no number is refused") {
  CHECK_THROWS_AS(ulp_of(std::numeric_limits<double>::quiet_NaN()), nipref::data::BadInput);
  CHECK_THROWS_AS(ulp_of(std::numeric_limits<double>::infinity()), nipref::data::BadInput);
}
