#include <nipref/ref/number/internal/largest_value.hpp>
#include <nipref/ref/number/interval.hpp>

#include "support/intervals.hpp"
#include "support/test.hpp"

using namespace nipref::ref;

namespace {

double middle(const Interval& x) { return static_cast<double>(middle_of(x)); }

/// sin x - x/3 + tilt x: largest where cos x = 1/3 - tilt.
FunctionOver tilted(const Interval& x, double tilt) {
  const Interval rise = Interval(tilt, x.precision()) - Interval(1L, x.precision()) / 3;
  return {sin(x) + rise * x, cos(x) + rise, -sin(x)};
}

}  // namespace

TEST_CASE("the largest value of every function so near, and its place, are enclosed, not vacuously") {
  const WorkingDigits working(40);
  const Interval range(0.01, 6.0, working_bits()), none(working_bits());
  const auto largest = [&](double tilt, const Interval& value_error, const Interval& slope_error) {
    return *largest_value([&](const Interval& x) { return tilted(x, tilt); }, range, value_error,
                          slope_error);
  };
  const LargestValue exact = largest(0, none, none);
  const double place = std::acos(1.0 / 3), value = std::sin(place) - place / 3;
  CHECK(middle(exact.place) == doctest::Approx(place).epsilon(1e-15));
  CHECK(middle(exact.value) == doctest::Approx(value).epsilon(1e-15));
  CHECK(width_of(exact.place) <= 2 * 1e-37);
  CHECK(width_of(exact.value) <= 2 * 1e-37);
  const Interval off(1e-20, working_bits());
  const LargestValue about = largest(0, 6 * off, off);
  for (const double tilt : {1e-20, -1e-20}) {
    const LargestValue other = largest(tilt, none, none);
    CHECK(is_inside(other.value, about.value));
    CHECK(is_inside(other.place, about.place));
    CHECK_FALSE(is_inside(other.place, exact.place));
  }
  CHECK(width_of(about.place) <= 2 * 1e-18);
  CHECK(width_of(about.value) <= 2 * 1e-18);
}

TEST_CASE("two peaks as high as each other both count, a lower one does not, one at an end is not proven") {
  const WorkingDigits working(30);
  const Interval none(working_bits());
  // -(x^2 - 1)^2 + tilt x
  const auto with = [&](double tilt) {
    return [=](const Interval& x) -> FunctionOver {
      const Interval rest = square(x) - 1, rise(tilt, x.precision());
      return {rise * x - square(rest), rise - 4 * (x * rest), 4 - 12 * square(x)};
    };
  };
  const auto both = largest_value(with(0), Interval(-3.0, 2.5, working_bits()), none, none);
  REQUIRE(both);
  CHECK(std::fabs(middle(both->value)) <= 1e-25);
  CHECK(mpfr_cmp_d(both->place.lower(), -0.999) < 0);
  CHECK(mpfr_cmp_d(both->place.upper(), 0.999) > 0);
  const auto one = largest_value(with(1e-3), Interval(-3.0, 2.5, working_bits()), none, none);
  REQUIRE(one);
  CHECK(mpfr_cmp_d(one->place.lower(), 0.999) > 0);
  CHECK_FALSE(largest_value(with(0), Interval(0.0, 0.5, working_bits()), none, none));
  CHECK_FALSE(largest_value(with(0), Interval(1.5, 2.5, working_bits()), none, none));
}
