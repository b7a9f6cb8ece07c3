#include <nipref/fast/memory/convolutions.hpp>

#include "support/test.hpp"

using namespace nipref::fast;

TEST_SUITE_BEGIN("fast memory");

TEST_CASE("J5 under the load: no sign there, and nothing remembered before the start") {
  CHECK(J5(7, 0, 1, 2, 2) == 0);
  CHECK(J5(7, 5, 1, 0, 3) == 7);
  CHECK(J5(7, 5, 1, 0, -3) == -7);
  CHECK(J5(0, 5, 0, 2, 1) == 0);  // a rate of 0: as long before as after
  CHECK(J5(0, 5, 0, 2, 3) == 10);
  CHECK(J6(7, 5, 1, 2, 0.5) == J5(7, 5, 1, 2, 0.5));
}

TEST_CASE("bad input to J names its argument") {
  using nipref::data::BadInput;
  const double nan = std::nan(""), infinity = HUGE_VAL;
  CHECK_THROWS_WITH_AS(J1(-1, 1, 1, 1, 1), "lambda = -1: must be from 0 to 1e150", BadInput);
  CHECK_THROWS_AS(J2(1, -1, 1, 1, 1), BadInput);
  CHECK_THROWS_AS(J3(1, 1, nan, 1, 1), BadInput);
  CHECK_THROWS_AS(J4(1, 1, 1, -1e-300, 1), BadInput);
  CHECK_THROWS_AS(J4(1, 1, 1, 1, -infinity), BadInput);
  CHECK_THROWS_AS(J5(nan, 1, 1, 1, 1), BadInput);
  CHECK_THROWS_AS(J6(1, infinity, 1, 1, 1), BadInput);
}

TEST_SUITE_END();
