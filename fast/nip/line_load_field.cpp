#include <cmath>
#include <ranges>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/contact_field.hpp>
#include <nipref/fast/nip/line_load_field.hpp>
#include <nipref/fast/sheet/field.hpp>

namespace nipref::fast {
namespace {

using data::SheetLoad;

/// Calls add(distance from the load in half-thicknesses, kind of load, force) for each load that is not 0.
void for_each_load(const auto& loads, double half_thickness, const InnerPoint& point, const auto& add) {
  static_cast<void>(checked_points({&point, 1}, half_thickness));
  for (const FaceLoad& load : loads) {
    const double alpha = (point.y - load.y) / half_thickness;
    if (alpha == 0 && std::fabs(point.depth) == 1)
      throw data::BadInput("field.positions", point.y, "must not be the place of a line load on a face");
    if (load.normal != 0) add(alpha, SheetLoad::normal, load.normal);
    if (load.shear != 0) add(alpha, SheetLoad::shear, load.shear);
  }
}

}  // namespace

std::vector<InnerStresses> line_load_stresses(std::span<const FaceLoad> loads, double half_thickness,
                                              std::span<const InnerPoint> points) {
  std::vector<InnerStresses> result;
  const std::size_t half = loads.size() / 2;
  for (const InnerPoint& point : points) {
    const auto sum_over = [&](const auto& some) {
      SheetStresses sum{};
      for_each_load(some, half_thickness, point, [&](double alpha, SheetLoad kind, double force) {
        sum = sum + force / half_thickness * sheet_stresses(alpha, point.depth, kind);
      });
      return sum;
    };
    // Each half from its end inwards, so that what is 0 by symmetry is exactly 0.
    const SheetStresses sum =
        sum_over(loads.first(half)) + sum_over(loads.subspan(half) | std::views::reverse);
    result.push_back({{sum.across, 0}, {sum.along, 0}, {sum.shear, 0}});
  }
  return result;
}

std::vector<InnerDisplacements> line_load_displacements(std::span<const FaceLoad> loads,
                                                        double half_thickness,
                                                        const data::ElasticMaterial& material,
                                                        std::span<const InnerPoint> points) {
  const double compliance = material.normal_compliance(), poisson = material.poisson;
  std::vector<InnerDisplacements> result;
  for (const InnerPoint& point : points) {
    double u = 0, v = 0;
    // Where v of a single load is counted from cancels between the loads.
    for_each_load(loads, half_thickness, point, [&](double alpha, SheetLoad kind, double force) {
      u -= force * sheet_u(alpha, std::fabs(point.depth), kind, poisson);
      v += force * sheet_v(alpha, 0, point.depth, kind, poisson);
    });
    result.push_back({{compliance * u, 0}, {point.y == 0 ? 0 : compliance * v, 0}});
  }
  return result;
}

}  // namespace nipref::fast
