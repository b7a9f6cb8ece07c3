#include <algorithm>
#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/nip/line_loads.hpp>

namespace nipref::fast {
namespace {

double parabola(const LineLoadNip& nip, double y) { return y * y / (2 * nip.roller_radius); }

/// The load of the element around y; nothing outside the contact.
FaceLoad load_around(const LineLoadNip& nip, double y) {
  check_position(y);
  if (nip.is_symmetric) y = -std::fabs(y);
  // A place on a border counts to the trailing element, as far as rounding knows borders.
  const double border = 0x1p-50 * nip.leading_length;
  const double from_end = nip.leading_length - y + border;
  if (from_end < 0 || y < -nip.trailing_length() - border) return {};
  const auto element = static_cast<std::size_t>(from_end / nip.element_width());
  return nip.loads[std::min(element, nip.loads.size() - 1)];
}

void check_beside_loads(const LineLoadNip& nip, double y) {
  check_position(y);
  if (std::ranges::find(nip.loads, y, &FaceLoad::y) != nip.loads.end())
    throw data::BadInput("y", y, "must not be the place of a line load");
}

double shear_size(const FaceLoad& load) { return std::fabs(load.shear); }

}  // namespace

int LineLoadNip::trailing_elements() const { return static_cast<int>(loads.size()) - leading_elements; }
double LineLoadNip::trailing_length() const {
  return leading_length * (static_cast<double>(trailing_elements()) / leading_elements);
}

double LineLoadNip::leading_displacement() const { return indentation - parabola(*this, leading_length); }
double LineLoadNip::trailing_displacement() const { return indentation - parabola(*this, trailing_length()); }

double LineLoadNip::load() const {
  double sum = 0;
  for (const FaceLoad& load : loads) sum += load.normal;
  return sum;
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
  double sum = 0;
  for (const FaceLoad& load : loads) sum += load.normal * std::max(load.y, 0.0);
  return sum;
}
double LineLoadNip::trailing_moment() const {
  double sum = 0;
  for (const FaceLoad& load : loads) sum += load.normal * std::min(load.y, 0.0);
  return sum;
}
double LineLoadNip::rolling_resistance() const {
  return is_symmetric ? 0 : (leading_moment() + trailing_moment()) / (load() * roller_radius);
}

double LineLoadNip::creep_ratio() const {
  if (gripped_creep) return *gripped_creep;
  const auto at = [&](double y) { return sheet->tangential_displacement(loads, y, *spent); };
  if (is_symmetric) return at(leading_length) / leading_length;
  return (at(leading_length) - at(-trailing_length())) / contact_length();
}

std::vector<double> LineLoadNip::shear_zeros() const {
  if (!gripped_creep) return {};
  std::vector<double> places{0};
  for (auto ahead = static_cast<std::size_t>(leading_elements) - 1; ahead > 0; --ahead) {
    if ((loads[ahead].shear < 0) != (loads[ahead - 1].shear < 0))
      places.push_back((leading_elements - static_cast<double>(ahead)) * element_width());
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
  return sheet->normal_displacement(loads, y, *spent);
}

double LineLoadNip::tangential_displacement(double y) const {
  check_beside_loads(*this, y);
  if (y == 0) return 0;
  const double to_point = sheet->tangential_displacement(loads, y, *spent);
  return is_symmetric ? to_point : to_point - sheet->tangential_displacement(loads, 0, *spent);
}

bool LineLoadNip::presses_everywhere() const {
  return std::ranges::all_of(loads, [](const FaceLoad& load) { return load.normal >= 0; });
}

}  // namespace nipref::fast
