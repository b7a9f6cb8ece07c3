#include <doctest/doctest.h>

#include <nipref/fast/number/internal/interpolation.hpp>

TEST_CASE(
    "functions are interpolated between Chebyshev points to rounding, next to the ends and at the points, too") {
  constexpr double length = 3;
  constexpr Eigen::Index count = 60;
  const Eigen::ArrayXd points = nipref::fast::internal::chebyshev_points(length, count);
  Eigen::ArrayXd places(6);
  places << 0, 1e-9, 0.1, points(7), 1.7, length;
  const Eigen::ArrayXd values =
      (nipref::fast::internal::interpolation(places, length, count) * points.exp().matrix()).array();
  CHECK((values / places.exp() - 1).abs().maxCoeff() < 2e-15);
  CHECK(values(3) == doctest::Approx(std::exp(points(7))).epsilon(1e-16));
}
