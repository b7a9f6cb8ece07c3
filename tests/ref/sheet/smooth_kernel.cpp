#include <nipref/ref/number/internal/chebyshev_sum.hpp>
#include <nipref/ref/number/interval.hpp>

#include "support/intervals.hpp"
#include "support/test.hpp"

using namespace nipref::ref;

TEST_CASE("the smooth kernels' constants 28, 127 and 226 are those of their ellipse") {
  constexpr mpfr_prec_t bits = 64;
  // In units of a panel's half-length, 1/8, the semi-axes of the ellipse are 14 and sqrt(197).
  const Interval semi_major = sqrt(Interval(197L, bits));
  CHECK(lowest(semi_major + 14) > 28);
  CHECK(highest(semi_major / 8) <= 1.76);
  const Interval left = 2 - Interval(1.75, bits), Q = 2 / left + 4 / square(left), reach(1.76, bits);
  CHECK(highest(reach * Q) < I1_shape.variation);
  CHECK(highest(reach * (Interval(1.75, bits) * Q + 1)) < 226.5);
  CHECK(highest(reach * (Interval(1.75, bits) * Q + 1)) < I3_integral_shape.variation);
  // Si(pi)/2 by its series, whose terms alternate and decrease from the second on.
  Interval term = Interval::pi(bits), sum = term;
  for (long k = 1; k <= 10; ++k) {
    term = -(term * square(Interval::pi(bits)) / (2 * k * (2 * k + 1)));
    sum = sum + term / (2 * k + 1);
  }
  CHECK(highest(sum / 2) < 1);
}

TEST_CASE("Clenshaw's sum in Float is as near to that in intervals as the count of its roundings says") {
  const WorkingDigits working(20);
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> within(-1, 1);
  double largest = 0;
  for (int round = 0; round < 200; ++round) {
    const long terms = 1 + round % 40;
    // Half of the points are near the end, where the recurrence grows.
    const Float x =
        round % 2 == 0 ? Float(within(random)) / 3 : Float(1 - within(random) * within(random) / 1e6);
    std::vector<Float> coefficients;
    Float counted = 0;
    for (long n = 0; n < terms; ++n) {
      coefficients.push_back(Float(within(random)) / 3);
      counted += 16 * terms * (n + 1) * abs(coefficients.back());
    }
    const Interval exact = interval_of(x, 400);
    Interval truth(400), before(1L, 400), here = exact;
    for (const Float& coefficient : coefficients) {
      truth = truth + interval_of(coefficient, 400) * before;
      Interval after = 2 * exact * here - before;
      before = std::exchange(here, std::move(after));
    }
    const Interval missed = distance_from(chebyshev_sum(coefficients, x), truth) /
                            interval_of(Float(counted * std::numeric_limits<Float>::epsilon()));
    largest = std::max(largest, highest(missed));
  }
  CHECK(largest <= 1);
  CHECK(largest >= 1e-4);
}
