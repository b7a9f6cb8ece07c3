#pragma once
#include <array>
#include <cstddef>

#include <nipref/fast/sheet/internal/half_planes.hpp>

namespace nipref::fast::internal {

/// I5 and I7 as power series in w - c about a point c on the middle plane.
struct FieldSeries {
  /// The truncation error at a distance of sqrt(5)/2, with singularities 3 away or more, is 0.373^38 < 1e-16.
  static constexpr std::size_t count = 38;
  using Coefficients = std::array<double, count>;

  Coefficients I5{}, I7{};

  void add(double factor, const FieldSeries& other);
};

/// The series about c of the rests of I5 and I7 without the half-planes' parts, see near_rest, for a load at 0.
FieldSeries rest_series(double c);

/// The sums over loads of the functions of pressure and of shear, as series about one point.
struct StressSeries {
  FieldSeries pressure, shear;

  /// Adds the whole field of loads that are at least 3 away from the point. `side` is 1 if they are at smaller alpha,
  /// else -1.
  void add_far(const FarLoads& loads, double side);
  /// The stresses at the distance `along` from the point of expansion and at a depth from -1 to 1.
  [[nodiscard]] SheetStresses at(double along, double depth) const;
};

}  // namespace nipref::fast::internal
