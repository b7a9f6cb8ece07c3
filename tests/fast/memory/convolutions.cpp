#include <nipref/fast/memory/convolutions.hpp>

#include "support/test.hpp"

using namespace nipref::fast;

TEST_CASE("J5 under the load has no sign there, and remembers nothing before the start") {
  CHECK(J5(7, 0, 1, 2, 2) == 0);
  CHECK(J5(7, 5, 1, 0, 3) == 7);
  CHECK(J5(7, 5, 1, 0, -3) == -7);
  CHECK(J5(0, 5, 0, 2, 1) == 0);  // rate 0: the load is ahead of the point as long as behind it
  CHECK(J5(0, 5, 0, 2, 3) == 10);
  CHECK(J6(7, 5, 1, 2, 0.5) == J5(7, 5, 1, 2, 0.5));
}

TEST_CASE("bad input to J names its argument") {
  CHECK_REFUSED(J1(-1, 1, 1, 1, 1), "lambda = -1: must be from 0 to 1e150");
  CHECK_REFUSED(J3(1, 1, not_a_number, 1, 1), "b = nan");
  CHECK_REFUSED(J4(1, 1, 1, -1e-300, 1), "t = -1e-300");
  CHECK_REFUSED(J4(1, 1, 1, 1, -infinite), "T = -inf");
  CHECK_REFUSED(J5(not_a_number, 1, 1, 1, 1), "gamma0 = nan");
  CHECK_REFUSED(J6(1, infinite, 1, 1, 1), "a = inf");
}
