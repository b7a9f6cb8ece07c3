#include <doctest/doctest.h>

#include <nipref/ref/sheet/internal/smooth_kernel.hpp>

using namespace nipref::ref;

TEST_CASE("the smooth kernels' constants 28, 127 and 226 are those of their ellipse") {
  constexpr mpfr_prec_t bits = 64;
  const auto upper = [](const Interval& x) { return mpfr_get_d(x.upper(), MPFR_RNDU); };
  // In half lengths of a panel, 1/8, its semi-axes are 14 and sqrt(197).
  const Interval semi_major = sqrt(Interval(197L, bits));
  CHECK(mpfr_get_d((semi_major + 14).lower(), MPFR_RNDD) > 28);
  CHECK(upper(semi_major / 8) <= 1.76);
  const Interval left = 2 - Interval(1.75, bits), Q = 2 / left + 4 / square(left), reach(1.76, bits);
  CHECK(upper(reach * Q) < I1_shape.variation);
  CHECK(upper(reach * (Interval(1.75, bits) * Q + 1)) < 226.5);
  CHECK(upper(reach * (Interval(1.75, bits) * Q + 1)) < I3_integral_shape.variation);
  // Si(pi)/2 by its series, whose terms alternate and fall from the second on.
  Interval term = Interval::pi(bits), sum = term;
  for (long k = 1; k <= 10; ++k) {
    term = -(term * square(Interval::pi(bits)) / (2 * k * (2 * k + 1)));
    sum = sum + term / (2 * k + 1);
  }
  CHECK(upper(sum / 2) < 1);
}
