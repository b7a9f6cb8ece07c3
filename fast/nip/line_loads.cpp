#include <algorithm>
#include <cmath>
#include <ranges>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/inner_field.hpp>
#include <nipref/fast/nip/line_loads.hpp>
#include <nipref/fast/number/internal/checks.hpp>
#include <nipref/fast/sheet/field.hpp>
#include <nipref/fast/sheet/internal/half_planes.hpp>

namespace nipref::fast {
namespace {

double parabola(const LineLoadNip& nip, double y) { return y * y / (2 * nip.roller_radius); }

/// The load of the element around y; nothing outside the contact.
FaceLoad load_around(const LineLoadNip& nip, double y) {
  internal::check_finite("y", y);
  if (nip.is_symmetric) y = -std::fabs(y);
  // A place on a border, to rounding, belongs to the trailing element.
  const double border = 0x1p-50 * nip.leading_length;
  const double from_end = nip.leading_length - y + border;
  if (from_end < 0 || y < -nip.trailing_length() - border) return {};
  const auto element = static_cast<std::size_t>(from_end / nip.element_width());
  return nip.loads[std::min(element, nip.loads.size() - 1)];
}

void check_beside_loads(const LineLoadNip& nip, double y) {
  internal::check_finite("y", y);
  if (std::ranges::find(nip.loads, y, &FaceLoad::y) != nip.loads.end())
    throw data::BadInput("y", y, "must not be the place of a line load");
}

double sum(const LineLoadNip& nip, const auto& part) {
  double sum = 0;
  for (const FaceLoad& load : nip.loads) sum += part(load);
  return sum;
}

double shear_size(const FaceLoad& load) { return std::fabs(load.shear); }

/// Calls add(distance from the load in half-thicknesses, kind of load, force) for each load that is not 0.
void for_each_load(const auto& loads, double half_thickness, const InnerPoint& point, const auto& add) {
  check_inside(point);
  for (const FaceLoad& load : loads) {
    const double alpha = (point.y - load.y) / half_thickness;
    if (alpha == 0 && std::fabs(point.depth) == 1)
      throw data::BadInput("field.positions", point.y, "must not be the place of a line load on a face");
    if (load.normal != 0) add(alpha, data::SheetLoad::normal, load.normal);
    if (load.shear != 0) add(alpha, data::SheetLoad::shear, load.shear);
  }
}

}  // namespace

int LineLoadNip::trailing_elements() const { return static_cast<int>(loads.size()) - leading_elements; }
double LineLoadNip::trailing_length() const {
  return leading_length * (static_cast<double>(trailing_elements()) / leading_elements);
}

double LineLoadNip::leading_displacement() const { return indentation - parabola(*this, leading_length); }
double LineLoadNip::trailing_displacement() const { return indentation - parabola(*this, trailing_length()); }

double LineLoadNip::load() const {
  return sum(*this, [](const FaceLoad& load) { return load.normal; });
}

double LineLoadNip::peak_pressure() const {
  return std::ranges::max_element(loads, {}, &FaceLoad::normal)->normal / element_width();
}
double LineLoadNip::peak_pressure_position() const {
  return std::ranges::max_element(loads, {}, &FaceLoad::normal)->y;
}
double LineLoadNip::peak_shear() const {
  return shear_size(*std::ranges::max_element(loads, {}, shear_size)) / element_width();
}
double LineLoadNip::peak_shear_position() const { return std::ranges::max_element(loads, {}, shear_size)->y; }

double LineLoadNip::leading_moment() const {
  return sum(*this, [](const FaceLoad& load) { return load.normal * std::max(load.y, 0.0); });
}
double LineLoadNip::trailing_moment() const {
  return sum(*this, [](const FaceLoad& load) { return load.normal * std::min(load.y, 0.0); });
}
double LineLoadNip::rolling_resistance() const {
  return is_symmetric ? 0 : (leading_moment() + trailing_moment()) / (load() * roller_radius);
}

double LineLoadNip::creep_ratio() const {
  if (gripped_creep) return *gripped_creep;
  if (is_symmetric) return tangential(leading_length) / leading_length;
  return (tangential(leading_length) - tangential(-trailing_length())) / contact_length();
}

std::vector<double> LineLoadNip::shear_zeros() const {
  if (!gripped_creep) return {};
  std::vector<double> places{0};
  double inner = 0;  // the last load that is not 0
  for (auto ahead = static_cast<std::size_t>(leading_elements); ahead-- > 0;) {
    const double shear = loads[ahead].shear;
    if (std::min(shear, inner) < 0 && std::max(shear, inner) > 0)
      places.push_back((leading_elements - 1 - static_cast<double>(ahead)) * element_width());
    if (shear != 0) inner = shear;
  }
  return places;
}

double LineLoadNip::pressure(double y) const { return load_around(*this, y).normal / element_width(); }
double LineLoadNip::shear(double y) const {
  const double trailing = load_around(*this, y).shear / element_width();
  return is_symmetric && !std::signbit(y) ? 0 - trailing : trailing;
}

double LineLoadNip::normal_displacement(double y) const {
  check_beside_loads(*this, y);
  return sheet(FaceDirection::normal, loads, y, *spent);
}

double LineLoadNip::tangential_displacement(double y) const {
  check_beside_loads(*this, y);
  if (y == 0) return 0;
  return is_symmetric ? tangential(y) : tangential(y) - tangential(0);
}

bool LineLoadNip::presses_everywhere() const {
  return std::ranges::all_of(loads, [](const FaceLoad& load) { return load.normal >= 0; });
}

std::vector<InnerStresses> line_load_stresses(std::span<const FaceLoad> loads, double half_thickness,
                                              std::span<const InnerPoint> points) {
  std::vector<InnerStresses> result;
  const std::size_t half = loads.size() / 2;
  for (const InnerPoint& point : points) {
    const auto sum_over = [&](const auto& some) {
      SheetStresses sum{};
      for_each_load(some, half_thickness, point, [&](double alpha, data::SheetLoad kind, double force) {
        sum = sum + force / half_thickness * sheet_stresses(alpha, point.depth, kind);
      });
      return sum;
    };
    // Each half is summed from its end inwards, so that sums that are 0 by symmetry are exactly 0.
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
    // The reference point of v of a single load cancels between the loads.
    for_each_load(loads, half_thickness, point, [&](double alpha, data::SheetLoad kind, double force) {
      u -= force * sheet_u(alpha, std::fabs(point.depth), kind, poisson);
      v += force * sheet_v(alpha, 0, point.depth, kind, poisson);
    });
    result.push_back({{compliance * u, 0}, {point.y == 0 ? 0 : compliance * v, 0}});
  }
  return result;
}

}  // namespace nipref::fast
