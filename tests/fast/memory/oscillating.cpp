#include <doctest/doctest.h>

#include <cmath>

#include <nipref/fast/memory/internal/fading.hpp>
#include <nipref/fast/number/internal/exponential_integrals.hpp>

namespace nipref::fast::internal {
namespace {

const Complex rates[] = {{0.3, 2}, {30, -200}, {100, 450}, {2000, 9000}};
const double places[] = {-3.0, -1.0, -0.6, -0.03, 1e-6, 0.2, 0.97, 2.0};

TEST_CASE("memories of complex rates from tables, or by parts, are those panel by panel") {
  for (const Complex rate : rates) {
    const OscillatingFade kept = fade(rate, {Kernel::I1, Kernel::I3}, Accuracy());
    for (const double w : places) {
      CAPTURE(rate.imag());
      CAPTURE(w);
      const SurfacePoint at = surface_point({w, 0}, Accuracy());
      for (const Kernel kernel : {Kernel::I1, Kernel::I3}) {
        const Complex panels = steady_memory(kernel, at, rate, Accuracy());
        // Next to the load I3 is what is left of its limit, pi/2.
        CHECK(std::abs(steady_memory(kernel, at, kept, Accuracy()) - panels) <
              1e-13 * std::abs(panels) + 2e-15 / std::abs(rate));
      }
    }
  }
}

TEST_CASE("the memory of a slope is the kernel's memory times the rate less the kernel") {
  const auto check = [](Kernel kernel, double w, const auto& kept, Complex rate) {
    CAPTURE(w);
    const SurfacePoint at = surface_point({w, 0}, Accuracy());
    const double value = kernel_at(kernel, at, Accuracy());
    const Complex expected = rate * steady_memory(kernel, at, kept, Accuracy()) - value;
    const Complex slope = steady_memory_of_slope(kernel, at, kept, Accuracy());
    CHECK(std::abs(slope - expected) < 1e-13 * (std::abs(value) + 1));
    // It falls like 1/rate, also where the kernel does not.
    if (kernel == Kernel::I3) CHECK(std::abs(slope) < 3 / (1 + std::abs(rate)));
  };
  for (const double w : places) {
    for (const Complex rate : rates) {
      const OscillatingFade kept = fade(rate, {Kernel::I1, Kernel::I3}, Accuracy());
      check(Kernel::I3, w, kept, rate);
      if (w > 0) check(Kernel::I1, w, kept, rate);
    }
    for (const double rate : {0.5, 300.0, 5000.0}) {
      const Fade kept = fade(Two{rate, 0}, {Kernel::I1, Kernel::I3}, Accuracy());
      check(Kernel::I3, w, kept, rate);
      if (w > 0) check(Kernel::I1, w, kept, rate);
    }
  }
}

TEST_CASE(
    "the exponential integral Ei of complex arguments: its equation, and values of tables on the real axis") {
  CHECK(scaled_Ei(1.0).real() == doctest::Approx(std::exp(-1) * 1.8951178163559368).scale(0).epsilon(1e-14));
  CHECK(scaled_Ei(10.0).real() ==
        doctest::Approx(std::exp(-10) * 2492.2289762418777).scale(0).epsilon(1e-14));
  for (const double size : {0.4, 2.4, 2.6, 12.0, 49.0, 51.0, 300.0}) {
    for (const double angle : {-1.5, -0.5, 0.1, 0.3, 1.2}) {
      CAPTURE(size);
      CAPTURE(angle);
      // f = e^-z Ei z obeys f' = 1/z - f.
      const Complex z = std::polar(size, angle);
      const double step = 0.003;
      const Complex slope = (45.0 * (scaled_Ei(z + step) - scaled_Ei(z - step)) -
                             9.0 * (scaled_Ei(z + 2 * step) - scaled_Ei(z - 2 * step)) +
                             (scaled_Ei(z + 3 * step) - scaled_Ei(z - 3 * step))) /
                            (60 * step);
      CHECK(std::abs(slope - (1.0 / z - scaled_Ei(z))) < 1e-9);
    }
  }
}

}  // namespace
}  // namespace nipref::fast::internal
