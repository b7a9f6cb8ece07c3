#include <nipref/fast/memory/internal/fading.hpp>

#include "support/test.hpp"

namespace nipref::fast::internal {
namespace {

const Complex rates[] = {{0.3, 2}, {30, -200}, {100, 450}, {2000, 9000}};
const double places[] = {-3.0, -1.0, -0.6, -0.03, 1e-6, 0.2, 0.97, 2.0};

TEST_CASE("memories of complex rates from tables, or by parts, are those panel by panel") {
  for (const Complex rate : rates) {
    const OscillatingFade kept = fade(rate, {Kernel::I1, Kernel::I3}, Accuracy());
    for (const double w : places) {
      CAPTURE(rate.imag(), w);
      const SurfacePoint at = surface_point({w, 0}, Accuracy());
      for (const Kernel kernel : {Kernel::I1, Kernel::I3}) {
        const Complex panels = steady_memory(kernel, at, rate, Accuracy());
        // Near the load I3 is a small difference from its limit pi/4, whose rounding error remains.
        CHECK(std::abs(steady_memory(kernel, at, kept, Accuracy()) - panels) <
              1e-13 * std::abs(panels) + 2e-15 / std::abs(rate));
      }
    }
  }
}

TEST_CASE("a short way under the load is remembered at a complex rate as at a real one") {
  constexpr double rate = 5;
  const Fade kept = fade(Two{rate, 0}, {Kernel::I1}, Accuracy());
  for (const double length : {1e-3, 1e-6, 1e-9, 1e-12, 1e-20}) {
    for (const double behind : {0.0, 0.001, 0.4, 1.0}) {
      CAPTURE(length, behind);
      const SurfacePoint start = surface_point({-behind * length, 0}, Accuracy()),
                         end = surface_point({(1 - behind) * length, 0}, Accuracy());
      const double real = memory(Kernel::I1, start, end, {length, 0}, kept, Accuracy());
      const Complex found = memory(Kernel::I1, start, end, {length, 0}, Complex(rate, 0), Accuracy());
      CHECK(std::abs(found - real) < 2e-15 * real);
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
    // The memory of the slope falls like 1/rate, even where the kernel itself is not small.
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

TEST_CASE("a slope that is not forgotten is the kernel's distance from its limit, also where this is small") {
  const Fade kept = fade(Two{0, 0}, {Kernel::I3}, Accuracy()),
             almost = fade(Two{1e-20, 0}, {Kernel::I3}, Accuracy());
  for (const double w : {-0.9, -0.6, -0.03, 0.2, 0.54, 0.9, 1.5, 5.0, 9.0, 30.0}) {
    CAPTURE(w);
    const SurfacePoint at = surface_point({w, 0}, Accuracy());
    const double slope = steady_memory_of_slope(Kernel::I3, at, kept, Accuracy()),
                 expected = steady_memory_of_slope(Kernel::I3, at, almost, Accuracy());
    CHECK(std::fabs(slope - expected) < 4e-15 * std::fabs(expected));
  }
}

}  // namespace
}  // namespace nipref::fast::internal
