#include <nipref/data/bad_input.hpp>
#include <nipref/ref/material/relaxation_terms.hpp>

#include "support/test.hpp"

using namespace nipref;
using ref::ComplexPart;
using ref::Exact;
using ref::ExactModulus;
using ref::ExactRatio;

namespace {

ExactModulus standard_solid(double spring, double second, double viscosity) {
  return {data::SpringModel::standard_linear, Exact(spring), Exact(second), Exact(viscosity)};
}

double gamma_of(const ExactRatio& theta, int number, ComplexPart part = ComplexPart::re) {
  return ref::relaxation_amplitude(theta, number, part, 20).to_double();
}
double lambda_of(const ExactRatio& theta, int number, ComplexPart part = ComplexPart::re) {
  return ref::relaxation_rate(theta, number, part, 20).to_double();
}

}  // namespace

TEST_CASE("terms of a material: the thesis's formulas for six constants, at any digits") {
  const double G1 = 3, G2 = 2, h1 = 0.7, K1 = 8, K2 = 5, h2 = 1.25;
  const ref::ExactRationalSolid both =
      ref::exact_springs(standard_solid(G1, G2, h1), standard_solid(K1, K2, h2));
  // (AIII.6)
  CHECK(gamma_of(both.theta1, 0) == doctest::Approx(1 / (2 * G1)).epsilon(1e-15));
  CHECK(gamma_of(both.theta1, 1) == doctest::Approx(1 / (2 * h1)).epsilon(1e-15));
  CHECK(lambda_of(both.theta1, 1) == doctest::Approx(G2 / h1).epsilon(1e-15));
  // (AIII.7), (AIII.8)
  const double a = 3 * h1 * h2, b = 3 * (h1 * (K1 + K2) + h2 * (G1 + G2)), c = 3 * (K1 + K2) * (G1 + G2);
  const double d = (6 * K1 + 2 * G1) * h1 * h2;
  const double e = 6 * K1 * (h2 * (G1 + G2) + h1 * K2) + 2 * G1 * (h1 * (K1 + K2) + h2 * G2);
  const double f = 6 * K1 * K2 * (G1 + G2) + 2 * G1 * G2 * (K1 + K2);
  const double root = std::sqrt(e * e - 4 * f * d), slow = (e - root) / (2 * d), fast = (e + root) / (2 * d);
  const auto amplitude = [&](double of, double other) {
    return ((b * d - a * e) * of - c * d + a * f) / ((of - other) * d * d);
  };
  CHECK(gamma_of(both.theta2, 0) == doctest::Approx(a / d).epsilon(1e-14));
  CHECK(lambda_of(both.theta2, 1) == doctest::Approx(slow).epsilon(1e-13));
  CHECK(lambda_of(both.theta2, 2) == doctest::Approx(fast).epsilon(1e-13));
  CHECK(gamma_of(both.theta2, 1) == doctest::Approx(amplitude(slow, fast)).epsilon(1e-11));
  CHECK(gamma_of(both.theta2, 2) == doctest::Approx(amplitude(fast, slow)).epsilon(1e-11));
  const ref::Enclosure more = ref::relaxation_rate(both.theta2, 1, ComplexPart::re, 200);
  CHECK(more.proven);
  CHECK(more.to_double() == lambda_of(both.theta2, 1));
  CHECK(ref::relaxation_rate(both.theta2, 1, ComplexPart::im, 30).error_of(0) == 0);
  CHECK_THROWS_WITH_AS((void)lambda_of(both.theta2, 3), doctest::Contains("from 1 to 2"), data::BadInput);
}

TEST_CASE(
    "terms of a material: of a pair that with the negative imaginary part is first, real rates have none") {
  // (p + 1)(p^2 + 4 p + 8): rates 1 and 2 -+ 2i; 1 over it has 1/5 and -1/10 +- i/20 there.
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
  CHECK_THROWS_AS((void)lambda_of({{1}, {1, 2, 1}}, 1), data::BadInput);
  // (p + 1)((p + 1)^2 + 1): the order of 1 and 1 -+ i could be any.
  CHECK_THROWS_WITH_AS((void)lambda_of({{1}, {2, 4, 3, 1}}, 1), doctest::Contains("1e-12"), data::BadInput);
}
