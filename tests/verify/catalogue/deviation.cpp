#include <nipref/ref/number/enclosure.hpp>
#include <nipref/verify/catalogue/deviation.hpp>

#include "support/test.hpp"

namespace {

using namespace nipref;

/// An enclosure made by hand: the value of a double and a bound.
ref::Enclosure enclosure(double value, double bound) {
  ref::Enclosure result{ref::Float(53), ref::Float(53), 16};
  mpfr_set_d(ref::raw(result.value), value, MPFR_RNDN);
  mpfr_set_d(ref::raw(result.error), bound, MPFR_RNDN);
  return result;
}

constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace

TEST_CASE("a deviation counts ulps of the value where there is no envelope") {
  const verify::Deviation found = verify::deviation(1 + 3 * epsilon, enclosure(1, 0), 0);
  CHECK(found.ulps == 3);
  CHECK(found.relative == 3 * epsilon);
  CHECK(found.scale == 1);
}

TEST_CASE("a deviation near a zero is measured against the envelope") {
  const verify::Deviation found = verify::deviation(2 * epsilon, enclosure(epsilon, 0), 4);
  CHECK(found.ulps == 0.25);
  CHECK(found.relative == 1);
  CHECK(found.of_scale == epsilon / 4);
}

TEST_CASE("the reference's own error bound is added") {
  CHECK(verify::deviation(1 + epsilon, enclosure(1, epsilon), 0).ulps == 2);
  CHECK(verify::deviation(1, enclosure(1, epsilon), 0).ulps == 1);
}

TEST_CASE("a difference below the smallest double is not lost") {
  ref::Enclosure truth = enclosure(0x1p-1074, 0);
  mpfr_mul_2si(ref::raw(truth.value), ref::raw(truth.value), -1, MPFR_RNDN);  // half of the smallest double
  CHECK(verify::deviation(0, truth, 0).ulps == 0.5);
}

TEST_CASE("what is no number deviates without limit") {
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const verify::Deviation found = verify::deviation(value, enclosure(1, 0), 1);
    CHECK(std::isinf(found.ulps));
    CHECK(std::isinf(found.relative));
    CHECK(std::isinf(found.of_scale));
  }
}

TEST_CASE("an exact zero that is met deviates by nothing") {
  const verify::Deviation found = verify::deviation(0, enclosure(0, 0), 0);
  CHECK(found.ulps == 0);
  CHECK(found.relative == 0);
}
