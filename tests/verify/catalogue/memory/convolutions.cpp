// The times at which moving loads of random tests pass the point.
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

#include "support/test.hpp"

using namespace nipref;

TEST_CASE("passing times lie on both sides of the start and of the present, and near them") {
  verify::Random random("passing times");
  int behind = 0, ahead = 0, before = 0, close = 0;
  for (int i = 0; i < 1000; ++i) {
    const double T = verify::draw_passing_time(1, random);
    CHECK(T != 1);
    before += T < 0;
    behind += T > 0 && T < 1;
    ahead += T > 1;
    close += std::fabs(T - 1) < 1e-10;
  }
  for (const int count : {behind, ahead, before, close}) CHECK(count > 50);
}
