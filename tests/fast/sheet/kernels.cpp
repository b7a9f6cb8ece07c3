#include "support/kernels.hpp"

#include <doctest/doctest.h>

using namespace fast_tests;

TEST_SUITE_BEGIN("fast sheet kernels");

TEST_CASE("within two units of the scale of the residue sum itself") {
  for (const Kernel& kernel : kernels()) {
    CAPTURE(kernel.name);
    for (const double x : log_uniform(0.3, 60, 3000, 1)) {
      const long double expected = kernel.residues(x);
      const double value = kernel.scalar(x, {});
      const double allowed = 2 * ulp(kernel.scale(x, static_cast<double>(expected)));
      CAPTURE(x);
      CHECK(static_cast<double>(std::fabs(value - expected)) <= allowed);
    }
  }
}

TEST_CASE("I6 within two units of its residue sums, its linear part included") {
  const std::vector<double> alphas = log_uniform(0.3, 60, 3000, 2);
  const std::vector<double> etas = log_uniform(0.3, 60, 3000, 3);
  for (std::size_t i = 0; i < alphas.size(); ++i) {
    const double a = alphas[i];
    // Every third pair differs by a few units in the last place: only the residues are left.
    const double e = i % 3 == 0 ? a * (1 + 0x1p-50) : etas[i];
    const long double linear = pi_long / 4 * (static_cast<long double>(e) - static_cast<long double>(a));
    const long double expected = linear + alpha_sum(a) - eta_sum(e);
    CAPTURE(a);
    CAPTURE(e);
    const double allowed = 2 * ulp(I6_scale(a, e, static_cast<double>(expected)));
    CHECK(static_cast<double>(std::fabs(nipref::fast::I6(a, e) - expected)) <= allowed);
  }
}

TEST_CASE("phase and exponent stay right until the residue underflows") {
  // Two steps of h later the first residue has been multiplied twice by e^(i z h): v(x + h) = 2 cos(m h)
  // e^(-K h) v(x) - e^(-2 K h) v(x - h). One double in the phase would break this by 1e-13 of the envelope.
  const ComplexL z = root(1);
  const Kernel& I7_kernel = kernels().back();
  constexpr double h = 0.5;
  const long double decay = std::exp(-z.imag() * static_cast<long double>(h));
  for (double x = 20; x < 350; x += 1.0 / 16) {
    const long double middle = I7_kernel.scalar(x, {});
    const long double before = I7_kernel.scalar(x - h, {});
    const long double expected =
        2 * std::cos(z.real() * static_cast<long double>(h)) * decay * middle - decay * decay * before;
    CAPTURE(x);
    const double allowed = 8 * 0x1p-52 * I7_kernel.residues.envelope(x + h) + 0x1p-1072;
    CHECK(static_cast<double>(std::fabs(I7_kernel.scalar(x + h, {}) - expected)) <= allowed);
  }
}

TEST_SUITE_END();
