#include <nipref/ref/memory/convolutions.hpp>

#include "support/decimal.hpp"
#include "support/test.hpp"

using namespace nipref::ref;
using nipref::data::BadInput;
using nipref::test::exact;

TEST_CASE("memory integrals are exactly 0 where nothing is integrated") {
  const Exact zero = exact("0"), one = exact("1"), two = exact("2"), before = exact("-1");
  const auto is_zero = [](const Enclosure& x) {
    return x.to_double() == 0 && mpfr_zero_p(raw(x.error)) != 0;
  };
  CHECK(is_zero(J1(one, one, one, one, before, 20)));
  CHECK(is_zero(J2(one, one, one, one, zero, 20)));
  CHECK(is_zero(J3(one, one, one, one, two, 20)));
  CHECK(is_zero(J4(one, one, one, one, one, 20)));
  CHECK(is_zero(J1(one, one, zero, one, two, 20)));
  CHECK(is_zero(J2(one, one, one, zero, two, 20)));
  CHECK(is_zero(J5(zero, one, one, zero, two, 20)));
  CHECK(is_zero(J5(one, zero, one, one, one, 20)));
  // Nothing fades, and the load passes after half of the time.
  CHECK(is_zero(J6(zero, one, zero, two, one, 20)));
}

TEST_CASE("memory integrals without decay are elementary") {
  CHECK(J2(exact("0"), exact("0"), exact("0"), exact("2"), exact("1.5"), 20).to_double() == 1.5);
  CHECK(J4(exact("3"), exact("3"), exact("0"), exact("0.25"), exact("0"), 20).to_double() ==
        doctest::Approx(0.25 * std::exp(-0.75)).epsilon(1e-15));
  CHECK(J5(exact("1"), exact("2"), exact("0"), exact("2"), exact("1.5"), 20).to_double() == 1);
}

TEST_CASE("memory integrals refuse rates that are too large, and too few digits") {
  const Exact one = exact("1");
  CHECK_REFUSED(J1(exact("1e16"), one, one, one, one, 20), "lambda = 1");
  CHECK_REFUSED(J6(one, one, one, one, one, 15), "digits = 15");
}
