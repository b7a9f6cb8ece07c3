#include <nipref/ref/material/relaxation_terms.hpp>

#include "support/test.hpp"

using namespace nipref;
using ref::ComplexPart;
using ref::ExactRatio;

namespace {

double gamma_of(const ExactRatio& theta, int number, ComplexPart part = ComplexPart::re) {
  return ref::relaxation_amplitude(theta, number, part, 20).to_double();
}
double lambda_of(const ExactRatio& theta, int number, ComplexPart part = ComplexPart::re) {
  return ref::relaxation_rate(theta, number, part, 20).to_double();
}

}  // namespace

TEST_CASE("terms of a material: of a pair the one with negative imaginary part is first") {
  // (p + 1)(p^2 + 4 p + 8) has the rates 1 and 2 -+ 2i. The amplitudes of its reciprocal are 1/5 and -1/10 +- i/20.
  const ExactRatio theta{{1}, {8, 12, 5, 1}};
  CHECK(lambda_of(theta, 1) == 1);
  CHECK(lambda_of(theta, 1, ComplexPart::im) == 0);
  for (const int number : {2, 3}) {
    const double sign = number == 2 ? -1 : 1;
    CHECK(lambda_of(theta, number) == 2);
    CHECK(lambda_of(theta, number, ComplexPart::im) == 2 * sign);
    CHECK(gamma_of(theta, number) == doctest::Approx(-0.1).epsilon(1e-15));
    CHECK(gamma_of(theta, number, ComplexPart::im) == doctest::Approx(0.05 * -sign).epsilon(1e-15));
  }
  CHECK(gamma_of(theta, 0) == 0);
  CHECK(gamma_of(theta, 1) == 0.2);
  CHECK_REFUSED(lambda_of(theta, 4), "from 1 to 3");
  CHECK_THROWS_AS((void)lambda_of({{1}, {1, 2, 1}}, 1), data::BadInput);
  // (p + 1)((p + 1)^2 + 1): the order of 1 and 1 -+ i could be any.
  CHECK_REFUSED(lambda_of({{1}, {2, 4, 3, 1}}, 1), "1e-12");
}
