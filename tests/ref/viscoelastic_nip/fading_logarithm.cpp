// The memory of the rolling sheet's logarithm: by quadrature, by its differential equation, and across the places
// where its sums change.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include <nipref/ref/viscoelastic_nip/internal/fading_logarithm.hpp>

using namespace nipref::ref;

namespace {

std::complex<double> in_double(const ComplexFloat& x) {
  return {static_cast<double>(x.re), static_cast<double>(x.im)};
}

/// int_0^inf e^{-rate w} ln|x - w| dw, w = e^{s - e^{-s}} from either side of the singularity.
std::complex<double> by_quadrature(std::complex<double> rate, double x) {
  std::complex<double> sum = 0;
  constexpr double step = 1.0 / 64;
  for (double s = -8; s < 8; s += step) {
    const double way = std::exp(s - std::exp(-s)), slope = way * (1 + std::exp(-s)) * step;
    const double start = std::fmax(x, 0);
    if (way > 0) sum += slope * std::exp(-rate * (start + way)) * std::log(way + (start - x));
    // From x back to 0, both ends singular or not: 1/(1 + e^{-pi sinh t}).
    if (x <= 0) continue;
    const double grow = std::exp(std::numbers::pi * std::sinh(s / 2)), left = grow / (1 + grow),
                 right = 1 / (1 + grow);
    if (left * right == 0) continue;
    sum += x * left * right * std::numbers::pi * std::cosh(s / 2) * step / 2 * std::exp(-rate * (x * right)) *
           std::log(x * left);
  }
  return sum;
}

}  // namespace

TEST_CASE("fading logarithm: real and complex rates, before and behind, by quadrature") {
  const WorkingDigits working(30);
  for (const std::complex<double> rate : {std::complex<double>{1, 0}, {1, 0.5}, {0.7, 3}, {2, -1}}) {
    for (const double x : {-4.0, -0.3, 0.02, 1.0, 5.0}) {
      CAPTURE(rate.imag());
      CAPTURE(x);
      const auto value = in_double(fading_logarithm({rate.real(), rate.imag()}, x));
      CHECK(std::abs(value - by_quadrature(rate, x)) <= 1e-11);
    }
  }
}

TEST_CASE("fading logarithm: of rate 0 its slope is the logarithm, as the others' with their rate") {
  const WorkingDigits working(40);
  const Float step = ldexp(Float(1), -40);
  for (const double rate : {0.0, 1e-3, 2.0}) {
    for (const double x : {-4.0, -0.3, 0.02, 5.0}) {
      CAPTURE(rate);
      CAPTURE(x);
      const auto at = [&](const Float& place) { return fading_logarithm(ComplexFloat(rate), place).re; };
      const Float slope = (at(x + step) - at(x - step)) / (2 * step);
      CHECK(abs(slope + rate * at(x) - log(abs(Float(x)))) < 1e-19);
    }
  }
}

TEST_CASE("scaled exponential integral: its differential equation holds where series and asymptotics meet") {
  // y = e^{-z} Ei(z): y' = 1/z - y, to the fourth order by five values.
  const WorkingDigits working(20);
  const double bits_nats = 20 * std::numbers::ln10;
  for (const double size : {0.5, 10.0, bits_nats + 12, bits_nats + 15, bits_nats + 20, 400.0}) {
    for (const double angle : {0.1, 0.8, 1.5, 1.65, 2.5, 3.0, -0.8, -2.5}) {
      CAPTURE(size);
      CAPTURE(angle);
      const Float step = 1e-4;
      const auto at = [&](int i) {
        return scaled_exponential_integral(
            {size * std::cos(angle) + i * step, Float(size * std::sin(angle))});
      };
      const ComplexFloat slope = (at(-2) - at(2) + (at(1) - at(-1)) * Float(8)) / (12 * step);
      const ComplexFloat z(size * std::cos(angle), size * std::sin(angle));
      const ComplexFloat residual = slope - ComplexFloat(1) / z + at(0);
      CHECK(static_cast<double>(abs(residual)) <= 1e-14);
    }
  }
}

TEST_CASE("scaled exponential integral: a real argument is the limit of complex ones") {
  const WorkingDigits working(25);
  for (const double z : {-60.0, -1.0, 0.5, 20.0, 90.0}) {
    CAPTURE(z);
    const ComplexFloat beside = scaled_exponential_integral({z, Float(1e-20)});
    const ComplexFloat real = scaled_exponential_integral({z});
    CHECK(static_cast<double>(abs(beside - real)) <= 1e-18 * static_cast<double>(abs(real)));
  }
}
