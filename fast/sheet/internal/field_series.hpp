#pragma once
#include <array>
#include <cstddef>

#include <nipref/fast/sheet/internal/half_planes.hpp>

namespace nipref::fast::internal {

/// I5 and I7 as power series in w - c about a place c on the middle plane.
struct FieldSeries {
  /// Up to a distance of sqrt(5)/2 of singularities that are 3 away or more: 0.373^38 < 1e-16.
  static constexpr std::size_t count = 38;
  using Coefficients = std::array<double, count>;

  Coefficients I5{}, I7{};

  void add(double factor, const FieldSeries& other);
};

/// Of what is left of them without the half-planes', see near_rest, for a load at 0: about any c.
FieldSeries rest_series(double c);

/// Pressure's and shear's functions, sums over loads, about one place.
struct StressSeries {
  FieldSeries pressure, shear;

  /// The whole of what loads make that are 3 away or more, as seen from the place; side: 1 if they are at smaller
  /// alpha, else -1.
  void add_far(const FarLoads& loads, double side);
  /// The stresses at a place that is `along` further and at a depth from -1 to 1.
  [[nodiscard]] SheetStresses at(double along, double depth) const;
};

}  // namespace nipref::fast::internal
