#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/fast/sheet/roots.hpp>

#include "support/kernels.hpp"
#include "support/test.hpp"

using namespace fast_tests;
using namespace nipref::fast;

TEST_SUITE_BEGIN("fast sheet roots");

TEST_CASE("roots agree with Newton in long double") {
  for (int n = 1; n <= 400; ++n) {
    const ComplexL expected = root(n);
    const std::complex<double> z = sheet_root(n);
    const double unit = ulp(static_cast<double>(std::abs(expected)));
    CAPTURE(n);
    CHECK(static_cast<double>(std::fabs(z.real() - expected.real())) <= 2 * unit);
    CHECK(static_cast<double>(std::fabs(z.imag() - expected.imag())) <= 2 * unit);
  }
}

TEST_CASE("the n-th root lies in the n-th strip and solves e^(2z) = -4z + e^(-2z)") {
  for (int n = 1; n <= 1000000; n += 1 + n / 7) {
    const std::complex<double> z = sheet_root(n);
    CAPTURE(n);
    CHECK(z.real() > 0);
    CHECK(z.imag() > (n - 0.5) * std::numbers::pi);
    CHECK(z.imag() < n * std::numbers::pi);
    // Modulus and argument of both sides; the argument loses what the reduction of 2 Im z by 2 pi n loses.
    const std::complex<double> right = -4.0 * z + std::exp(-2.0 * z);
    CHECK(2 * z.real() == doctest::Approx(std::log(std::abs(right))).epsilon(1e-14));
    CHECK(std::fabs(2 * (z.imag() - n * std::numbers::pi) - std::arg(right)) <= 8 * ulp(z.imag()));
  }
}

TEST_CASE("plain series: right where it converges, short of it by its first neglected terms elsewhere") {
  for (const double alpha : {-0.2, 0.1, 1.0, 7.0}) {
    CHECK(plain_series_I1(alpha, 500) == doctest::Approx(I1(alpha)).epsilon(1e-12).scale(1e-3));
  }
  const double error = std::fabs(plain_series_I1(1e-3, 500) - I1(1e-3));
  CHECK(error > 1e-2);
  CHECK(error < 1);
  CHECK(plain_series_I1(2.0, 1) != plain_series_I1(2.0, 2));
}

TEST_CASE("bad input") {
  using nipref::data::BadInput;
  CHECK_THROWS_AS(sheet_root(0), BadInput);
  CHECK_THROWS_AS(sheet_root(1000001), BadInput);
  CHECK_THROWS_AS(plain_series_I1(0.0, 10), BadInput);
  CHECK_THROWS_AS(plain_series_I1(std::nan(""), 10), BadInput);
  CHECK_THROWS_AS(plain_series_I1(1.0, 0), BadInput);
  CHECK_THROWS_AS(plain_series_I1(1.0, 501), BadInput);
}

TEST_SUITE_END();
