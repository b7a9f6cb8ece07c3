#include <nipref/fast/sheet/branch_points.hpp>
#include <nipref/fast/sheet/displacements.hpp>

#include "support/kernels.hpp"

using namespace fast_tests;
using nipref::data::BadInput;

namespace {
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
}  // namespace

TEST_CASE("even kernels are even and odd ones odd, to the last bit") {
  for (const Kernel& kernel : kernels()) {
    for (const double x : log_uniform(1e-300, 700, 500, 4)) {
      const double value = kernel.scalar(x, {});
      CHECK(kernel.scalar(-x, {}) == (kernel.odd ? -value : value));
    }
  }
  for (const double x : log_uniform(1e-3, 30, 200, 5)) {
    const double value = nipref::fast::I6(x, 1.5 * x);
    CHECK(nipref::fast::I6(-x, 1.5 * x) == value);
    CHECK(nipref::fast::I6(x, -1.5 * x) == value);
  }
}

TEST_CASE("kernels have no jump at any branch point") {
  // Values at neighbouring doubles may differ by the slope and by twice the promised error. The slope is taken from
  // points that are far enough apart.
  for (const Kernel& kernel : kernels()) {
    CAPTURE(kernel.name);
    for (const double x : nipref::fast::branch_points()) {
      const double left = std::nextafter(x, 0.0);
      const double right = std::nextafter(x, largest);
      const double reach = x * 0x1p-12;
      const double slope = (kernel.scalar(x + reach, {}) - kernel.scalar(x - reach, {})) / (2 * reach);
      const double at = kernel.scalar(x, {});
      const double allowed = 4 * ulp(kernel.scale(x, at));
      CAPTURE(x);
      CHECK(std::fabs(at - kernel.scalar(left, {}) - slope * (x - left)) <= allowed);
      CHECK(std::fabs(kernel.scalar(right, {}) - at - slope * (right - x)) <= allowed);
    }
  }
}

TEST_CASE("branch points ascend") {
  const auto points = nipref::fast::branch_points();
  REQUIRE(points.size() > 500);
  CHECK(points.front() > 0);
  CHECK(std::is_sorted(points.begin(), points.end()));
  for (const double regime : {0.5, 1.0, 12.0})
    CHECK(std::binary_search(points.begin(), points.end(), regime));
}

TEST_CASE("odd kernels vanish at zero, linearly down to the denormal numbers") {
  for (const Kernel& kernel : kernels()) {
    if (!kernel.odd) continue;
    CAPTURE(kernel.name);
    CHECK(kernel.scalar(0.0, {}) == 0);
    CHECK(kernel.scalar(-0.0, {}) == 0);
    const double slope = kernel.scalar(0x1p-40, {}) * 0x1p40;
    for (const double x : log_uniform(1e-307, 1e-12, 300, 6)) {
      CHECK(std::fabs(kernel.scalar(x, {}) - slope * x) <= 3 * ulp(slope * x));
    }
    CHECK(kernel.scalar(100 * smallest, {}) == std::nearbyint(100 * slope) * smallest);
  }
}

TEST_CASE("logarithmic kernels keep their digits down to the denormal numbers") {
  // I1 = -ln x - 0.35167539261870... + O(x^2). I6(a, e) - I1(a) tends to a number that does not depend on a as a -> 0.
  const double difference = nipref::fast::I6(1e-20, 0.7) - nipref::fast::I1(1e-20);
  for (const double x : {smallest, 3 * smallest, 0x1p-1022, 1e-300, 1e-100, 1e-20, 1e-9}) {
    CAPTURE(x);
    const double value = nipref::fast::I1(x);
    CHECK(std::fabs(value + std::log(x) + 0.3516753926187) <= 4 * ulp(value) + 1e-13);
    CHECK(std::fabs(nipref::fast::I6(x, 0.7) - value - difference) <= 6 * ulp(value));
  }
}

TEST_CASE("kernels of large arguments are their limits at infinity") {
  for (const Kernel& kernel : kernels()) {
    const double limit = kernel.odd ? std::numbers::pi / 4 : 0;
    for (const double x : {400.0, 1e3, 1e20, largest}) CHECK(kernel.scalar(x, {}) == limit);
    CHECK(kernel.scalar(350.0, {}) != (kernel.odd ? 0 : limit));  // still representable
  }
  using nipref::fast::I6;
  CHECK(I6(1e20, 3e20) == doctest::Approx(std::numbers::pi / 2 * 1e20).epsilon(1e-15));
  CHECK(I6(1e20, 1e20) == 0);
  CHECK(I6(largest, 1.0) == -std::numbers::pi / 4 * largest);
  CHECK(I6(1.0, largest) == std::numbers::pi / 4 * largest);
}

TEST_CASE("I2 is the step") {
  using nipref::fast::I2;
  CHECK(I2(smallest) == std::numbers::pi / 2);
  CHECK(I2(-7.0) == -std::numbers::pi / 2);
  CHECK(I2(0.0) == 0);
  CHECK_THROWS_AS(I2(std::nan("")), BadInput);
}

TEST_CASE("arguments outside the domain are refused by name") {
  for (const Kernel& kernel : kernels()) {
    CAPTURE(kernel.name);
    for (const double bad : {std::nan(""), infinite, -infinite})
      CHECK_THROWS_AS(kernel.scalar(bad, {}), BadInput);
    if (kernel.infinite_at_zero) CHECK_THROWS_AS(kernel.scalar(-0.0, {}), BadInput);
  }
  using namespace nipref::fast;
  CHECK_THROWS_WITH(I1(0.0), "alpha = 0: must be nonzero: the kernel is infinite there");
  CHECK_THROWS_WITH(I1(std::nan("")), "alpha = nan: must be a finite number");
  CHECK_THROWS_WITH(I6(1.0, infinite), "eta = inf: must be a finite number");
  CHECK_NOTHROW(I6(1.0, 0.0));
  CHECK_THROWS_AS(vs(0.0, 1.0, {1.0, 0.3}), BadInput);
  CHECK_THROWS_AS(F2(std::nan(""), 0.3), BadInput);
  std::vector<double> at{1.0}, value(1);
  CHECK_THROWS_AS(un(at, {1.0, 0.6}, value), BadInput);
}
