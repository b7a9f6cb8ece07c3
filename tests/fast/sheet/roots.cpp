#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/fast/sheet/roots.hpp>

#include "support/test.hpp"

using namespace nipref::fast;

TEST_CASE("roots and plain sums of residues refuse bad input") {
  using nipref::data::BadInput;
  CHECK_THROWS_AS(sheet_root(1000001), BadInput);
  CHECK_THROWS_AS(plain_series_I1(0.0, 10), BadInput);
  CHECK_THROWS_AS(plain_series_I1(std::nan(""), 10), BadInput);
  CHECK_THROWS_AS(plain_series_I1(1.0, 0), BadInput);
  CHECK_THROWS_AS(plain_series_I1(1.0, 501), BadInput);
}
