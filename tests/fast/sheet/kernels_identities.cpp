#include "support/kernels.hpp"
#include "support/test.hpp"

using namespace fast_tests;
using namespace nipref::fast;

TEST_SUITE_BEGIN("fast sheet kernels");

namespace {
/// Integral over (0, 40) of a function with at most a logarithm at 0: the trapezoidal rule in s, x = e^(s -
/// e^-s).
template <typename Function>
double integral_to_infinity(const Function& f) {
  constexpr double h = 1.0 / 64;
  double sum = 0;
  for (double s = -4; s < 3.75; s += h) {
    const double x = std::exp(s - std::exp(-s));
    sum += f(x) * x * (1 + std::exp(-s));
  }
  return sum * h;
}
}  // namespace

TEST_CASE("integrals over the whole half-line are the transforms at zero, times pi/2") {
  // f(a) = int g(x) cos(a x) dx has int f da = (pi/2) g(0); g(0) = 1/2 for I1 and for I7.
  CHECK(integral_to_infinity([](double a) { return I1(a); }) ==
        doctest::Approx(std::numbers::pi / 4).epsilon(1e-13));
  CHECK(integral_to_infinity([](double a) { return I7(a); }) ==
        doctest::Approx(std::numbers::pi / 4).epsilon(1e-13));
  // f(a) = int g(x) sin(a x) dx has int a-derivative da = f(inf) = pi/4; weighted: int a (f(inf) - f(a)) da
  // for I3, with 2/(sinh 2x + 2x) = 1/(2x) - x/6 + ..., is (pi/2)(1/6).
  const auto moment = [](double a) { return a * (std::numbers::pi / 4 - I3(a)); };
  CHECK(integral_to_infinity(moment) == doctest::Approx(std::numbers::pi / 12).epsilon(1e-12));
}

TEST_CASE("I4 has the derivative I7") {
  for (const double e : {0.01, 0.3, 0.7, 1.0, 2.5, 11.98, 12.1}) {
    constexpr double h = 0x1p-9;
    const auto difference = [e](double step) { return (I4(e + step) - I4(e - step)) / (2 * step); };
    CHECK((4 * difference(h) - difference(2 * h)) / 3 == doctest::Approx(I7(e)).epsilon(1e-9).scale(1));
  }
}

TEST_CASE("I6 = I1 + int 2 (cos a x - cosh x cos e x)/(x (sinh 2x + 2x)) dx") {
  const auto rest = [](double a, double e) {
    constexpr double h = 1.0 / 16;
    double sum = (1 + e * e - 1 - a * a - 1) / 8;  // half of the limit at x = 0, (e^2 - a^2 - 1)/4
    for (double x = h; x < 45; x += h) {
      sum += 2 * (std::cos(a * x) - std::cosh(x) * std::cos(e * x)) / (x * (std::sinh(2 * x) + 2 * x));
    }
    return sum * h;
  };
  for (const double a : {0.02, 0.4, 1.5, 6.0}) {
    for (const double e : {0.0, 0.3, 2.0, 5.0})
      CHECK(I6(a, e) == doctest::Approx(I1(a) + rest(a, e)).epsilon(1e-12).scale(1));
  }
}

TEST_CASE("influence functions are the thesis's combinations of the kernels") {
  const nipref::data::ElasticMaterial material{2.5, 0.3};
  const double theta1 = 1.3 / 2.5;
  const double theta2 = 1.3 * 0.4 / 2.5;
  const double pi = std::numbers::pi;
  for (const double a : {-3.0, -0.2, 0.05, 1.7, 20.0}) {
    CHECK(un(a, material) == doctest::Approx((theta1 + theta2) * I1(a) / pi).epsilon(1e-14));
    CHECK(us(a, material) ==
          doctest::Approx((theta2 * I2(a) - (theta1 + theta2) * I3(a)) / pi).epsilon(1e-13));
    for (const double e : {-4.0, 0.0, 0.6, 9.0}) {
      const double printed =
          -theta2 * I2(a) + (theta1 + theta2) * I3(a) - theta1 * (I4(e) + I5(e)) + (theta1 + theta2) * I4(e);
      CHECK(vn(a, e, material) == doctest::Approx(printed / pi).epsilon(1e-13).scale(0.1));
      CHECK(vs(a, e, material) ==
            doctest::Approx(((theta1 + theta2) * I6(a, e) + theta1 * I7(e)) / pi).epsilon(1e-14));
    }
  }
}

TEST_CASE("displacements due to shear separate: vs(a, e)/N - F2(e) does not depend on e") {
  const nipref::data::ElasticMaterial material{1.0, 1.0 / 3};
  for (const double a : {0.1, 2.0, 15.0}) {
    const double at_zero = vs(a, 0, material) / material.normal_compliance() - F2(0, material.poisson);
    for (const double e : {0.05, 0.49, 0.9, 3.0, 14.0}) {
      CHECK(vs(a, e, material) / material.normal_compliance() - F2(e, material.poisson) ==
            doctest::Approx(at_zero).epsilon(1e-13).scale(1));
    }
  }
}

TEST_CASE("far from the load the displacements are those of the thesis's closed terms") {
  const nipref::data::ElasticMaterial material{1.0, 0.2};
  const double difference = (material.theta1() - material.theta2()) / 4;
  CHECK(us(50, material) == doctest::Approx(-difference).epsilon(1e-14));  // (4.25)
  CHECK(F1(50, 0.2) == doctest::Approx(-difference / material.normal_compliance()).epsilon(1e-14));
  CHECK(F1(-50, 0.2) == -F1(50, 0.2));
  CHECK(F1(0, 0.2) == 0);
  CHECK(F2(50, 0.2) == doctest::Approx(12.5).epsilon(1e-15));
  CHECK(vn(50, 50, material) == doctest::Approx(0).scale(1e-1));
}

TEST_CASE("un in batches, and bad materials") {
  const nipref::data::ElasticMaterial material{3.0, 0.25};
  const std::vector<double> alpha = log_uniform(1e-4, 30, 900, 16);
  std::vector<double> value(alpha.size());
  un(alpha, material, value);
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    const double single = un(alpha[i], material);
    const double unit = ulp(std::max(std::fabs(single), kernels().front().residues.envelope(alpha[i])));
    CHECK(std::fabs(value[i] - single) <= 2 * unit);
  }
  using nipref::data::BadInput;
  CHECK_THROWS_AS(un(1.0, {-1.0, 0.3}), BadInput);
  CHECK_THROWS_AS(un(alpha, {1.0, 0.6}, value), BadInput);
  CHECK_THROWS_AS(vs(0.0, 1.0, material), BadInput);
  CHECK_THROWS_AS(F1(1.0, 0.7), BadInput);
  CHECK_THROWS_AS(F2(std::nan(""), 0.3), BadInput);
}

TEST_SUITE_END();
