// The stresses of one load as power series about places of the middle plane.
#include <nipref/fast/sheet/field.hpp>
#include <nipref/fast/sheet/internal/field_series.hpp>

#include "support/test.hpp"

using namespace nipref;
using namespace nipref::fast;

namespace {

constexpr data::SheetLoad both_loads[]{data::SheetLoad::normal, data::SheetLoad::shear};

double largest_part(const SheetStresses& a, const SheetStresses& b) {
  return std::max(
      {std::fabs(a.across - b.across), std::fabs(a.along - b.along), std::fabs(a.shear - b.shear)});
}

/// Between the series about c and the field itself less `planes` of it, over half a half-thickness on either side.
template <class Planes>
double largest_distance(const internal::StressSeries& series, double c, data::SheetLoad load, Planes planes) {
  double farthest = 0;
  for (const double along : {-0.5, -0.21, 0.0, 0.4, 0.5}) {
    for (const double depth : {-1.0, -0.7, 0.0, 0.3, 0.99, 1.0}) {
      const double alpha = c + along;
      if (alpha == 0) continue;
      const SheetStresses whole = sheet_stresses(alpha, depth, load), less = planes(alpha, depth, load);
      farthest = std::max(farthest, largest_part(series.at(along, depth),
                                                 {whole.across - less.across, whole.along - less.along,
                                                  whole.shear - less.shear}));
    }
  }
  return farthest;
}

/// Of both half-planes, by the parities.
SheetStresses planes_at(double alpha, double depth, data::SheetLoad load) {
  SheetStresses planes = internal::half_plane_stresses({std::fabs(alpha), std::fabs(depth)}, load);
  const double side = alpha < 0 ? -1 : 1, face = depth < 0 ? -1 : 1;
  if (load == data::SheetLoad::shear) return {side * planes.across, side * planes.along, face * planes.shear};
  return {planes.across, planes.along, side * face * planes.shear};
}

}  // namespace

TEST_CASE("near a load, what the sheet adds to the half-planes is a series about any place") {
  double farthest = 0;
  for (const double c : {0.0, 0.3, -0.3, 1.2, -1.9, 2.6, -4.0}) {
    for (const data::SheetLoad load : both_loads) {
      internal::StressSeries series;
      (load == data::SheetLoad::normal ? series.pressure : series.shear) = internal::rest_series(c);
      farthest = std::max(farthest, largest_distance(series, c, load, planes_at));
    }
  }
  MESSAGE("largest distance from the field less the half-planes' ", farthest);
  CHECK(farthest < 2e-14);  // next to the load both are as large as 60
}

TEST_CASE("3 away from a load all that it makes is a series of the roots' waves") {
  double farthest = 0;
  for (const double c : {3.0, -3.0, 4.7, -20.0}) {
    for (const data::SheetLoad load : both_loads) {
      const internal::AlongWaves waves(std::fabs(c));
      internal::AlongWaves none = waves;
      none.of.fill(0);
      internal::StressSeries series;
      const bool normal = load == data::SheetLoad::normal;
      series.add_far({normal ? waves : none, normal ? none : waves, normal ? 0.0 : 1.0}, c < 0 ? -1 : 1);
      farthest = std::max(farthest, largest_distance(series, c, load, [](double, double, data::SheetLoad) {
                            return SheetStresses{};
                          }));
    }
  }
  CHECK(farthest < 1e-15);
}
